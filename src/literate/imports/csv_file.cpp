// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/imports/csv_file.hpp"

#include <fmt/core.h>

#define CSV_IO_NO_THREAD
#include <libfccp/csv.h>

#include "literate/imports/import_error.hpp"
#include "system/lines.hpp"

namespace literate {
namespace {

using Quoting = io::double_quote_escape<',', '"'>;

std::vector<std::string> fields_of(std::string line) {
  std::vector<std::string> fields;
  for (char* begin = line.data();;) {
    char* const end = begin + (Quoting::find_next_column_end(begin) - begin);
    const bool is_last = *end == '\0';
    *end = '\0';
    char* first = begin;
    char* last = end;
    io::trim_chars<' ', '\t'>::trim(first, last);
    Quoting::unescape(first, last);
    fields.emplace_back(first, last);
    if (is_last) return fields;
    begin = end + 1;
  }
}

}  // namespace

std::vector<CsvRow> csv_rows(const std::string& file, const std::string& text) {
  std::vector<CsvRow> rows;
  unsigned number = 0;
  for (const std::string_view line : sys::lines_of(text)) {
    ++number;
    if (sys::stripped(line).empty() || line.starts_with('#')) continue;
    if (line.find('\0') != line.npos) {
      throw ImportError(fmt::format("{}:{}: the line holds a zero byte", file, number));
    }
    try {
      rows.push_back({number, fields_of(std::string(line))});
    } catch (const io::error::escaped_string_not_closed&) {
      throw ImportError(fmt::format("{}:{}: a quote is not closed", file, number));
    }
    const std::size_t n_expected = rows.front().fields.size();
    if (rows.back().fields.size() == n_expected) continue;
    throw ImportError(fmt::format("{}:{}: {} fields, where the first line has {}", file, number,
                                  rows.back().fields.size(), n_expected));
  }
  return rows;
}

}  // namespace literate
