// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace literate {

/// The fields of one line of a CSV file, and its number in the file.
struct CsvRow {
  unsigned line = 0;
  std::vector<std::string> fields;
};

/// A CSV file that becomes a table, and the places in it for messages.
struct CsvSource {
  std::string file;
  std::string table;

  /// «file:line: table 'name'».
  std::string at(unsigned line) const;
  /// «file:line:column: table 'name'», where column counts fields from 1.
  std::string at(unsigned line, std::size_t column) const;
};

/// The lines of a CSV text that are not empty and do not begin with #: fields separated by commas,
/// in double quotes where they hold commas, a double quote inside doubled (RFC 4180 without line
/// ends inside fields). Blanks around a field are taken off. Throws ImportError at line and column
/// for a quote that is not closed, a zero byte, and the first field that a line has more or fewer
/// than the first line.
std::vector<CsvRow> csv_rows(const CsvSource& source, const std::string& text);

}  // namespace literate
