// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace course {

/// A field of RFC 4180, in quotes where it needs them. One that a spreadsheet would take for a
/// formula, as it begins with = + - or @, gets a ' in front.
std::string csv_field(std::string_view text);

/// The fields of a line of RFC 4180, which may not go on in the next. Throws sys::SourceError
/// for a quote that is not closed, or stands inside a field.
std::vector<std::string> csv_fields(std::string_view line);

}  // namespace course
