// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sys {

/// Formats a field of a CSV file (RFC 4180), in quotes if it contains special characters.
std::string csv_field(std::string_view text);

/// Formats a line of a CSV file, including the line end.
std::string csv_line(const std::vector<std::string>& fields);

}  // namespace sys
