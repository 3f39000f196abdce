// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sys {

/// A field of a CSV file (RFC 4180), in quotes where it needs them to be read back as it is.
std::string csv_field(std::string_view text);

/// Such fields in a line, with its end.
std::string csv_line(const std::vector<std::string>& fields);

}  // namespace sys
