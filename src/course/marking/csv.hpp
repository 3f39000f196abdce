// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace course {

/// A field of RFC 4180, in quotes where it needs them. One that a spreadsheet would take for a
/// formula, because it begins with = + - or @, gets a ' in front.
std::string csv_field(std::string_view text);

}  // namespace course
