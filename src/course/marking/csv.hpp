// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace course {

/// A field of RFC 4180, in quotes where it needs them. One that a spreadsheet would take for a
/// formula, because it begins with = + - or @, gets a ' in front.
std::string csv_field(std::string_view text);

/// A field that was read, without its quotes, and where it begins.
struct CsvField {
  std::string text;
  std::string place;  ///< «file:line:column», the column in bytes
};

using CsvRow = std::vector<CsvField>;

/// Reads a file of RFC 4180 whole: lines end with LF or CR LF, a byte order mark and empty lines do
/// not count, blanks around a field that has no quotes neither. Throws sys::SourceError
/// «file:line:column: …» for a quote that is not closed, for text behind a closed one, and for a
/// row with more or fewer fields than the first.
std::vector<CsvRow> parse_csv(std::string_view text, const std::string& file);

}  // namespace course
