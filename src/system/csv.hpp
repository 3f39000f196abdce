// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sys {

/// A field of a CSV file, without its quotes, and where it begins.
struct CsvField {
  std::string text;
  unsigned line = 0;
  std::string place;  ///< «file:line:column», the column in bytes
};

using CsvRow = std::vector<CsvField>;

/// What a line means that begins with # and a blank, or is # alone.
enum class CsvComments { none, number_sign };

/// Reads the rows of a CSV text (RFC 4180): lines end with LF or CR LF; a byte order mark and empty
/// lines do not count, nor do blanks around a field. Throws SourceError «file:line:column: …» for a
/// quote that is not closed or stands within a field, for text behind a closed one, for a zero
/// byte, and for a row with more or fewer fields than the first.
std::vector<CsvRow> parse_csv(std::string_view text, const std::string& file,
                              CsvComments comments = CsvComments::none);

/// A field of RFC 4180, in quotes where it needs them to come back from parse_csv as it is.
std::string csv_field(std::string_view text);

/// The same for a file that a spreadsheet may open: a text that it would take for a formula,
/// because it begins with = + - or @, gets a ' in front.
std::string spreadsheet_field(std::string_view text);

/// Such fields in a line, with its end.
std::string csv_line(const std::vector<std::string>& fields);

}  // namespace sys
