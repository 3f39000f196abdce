// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace literate {

/// The fields of one line of a CSV file, and its number in the file.
struct CsvRow {
  unsigned line = 0;
  std::vector<std::string> fields;
};

/// The lines of a CSV text that are not empty and do not begin with #: fields separated by commas,
/// in double quotes where they hold commas, a double quote inside doubled (RFC 4180 without line
/// ends inside fields). Blanks around a field are taken off. `file` is for messages: ImportError
/// «file:line: …» tells a quote that is not closed and a line that has more or fewer fields than
/// the first.
std::vector<CsvRow> csv_rows(const std::string& file, const std::string& text);

}  // namespace literate
