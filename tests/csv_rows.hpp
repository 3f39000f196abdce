// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

using CsvRow = std::vector<std::string>;

/// The rows of a CSV text (RFC 4180), the first one with the names of the columns.
inline std::vector<CsvRow> csv_rows_of(const std::string& text) {
  std::vector<CsvRow> rows;
  CsvRow row{""};
  bool is_quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool is_doubled = c == '"' && is_quoted && i + 1 < text.size() && text[i + 1] == '"';
    if (is_doubled) ++i;
    if (c == '"' && !is_doubled) {
      is_quoted = !is_quoted;
    } else if (c == ',' && !is_quoted) {
      row.emplace_back();
    } else if (c == '\n' && !is_quoted) {
      rows.push_back(row);
      row = {""};
    } else {
      row.back() += c;
    }
  }
  return rows;
}

/// The same for a file.
inline std::vector<CsvRow> csv_rows(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return csv_rows_of({std::istreambuf_iterator<char>(stream), {}});
}
