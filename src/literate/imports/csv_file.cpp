// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/imports/csv_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#define CSV_IO_NO_THREAD
#include <libfccp/csv.h>

#include "literate/imports/import_error.hpp"
#include "system/lines.hpp"

namespace literate {
namespace {

using Quoting = io::double_quote_escape<',', '"'>;

/// Puts the fields of a line behind one another, up to one whose quote is not closed, which throws.
void split(std::string line, std::vector<std::string>& fields) {
  for (char* begin = line.data();;) {
    char* const end = begin + (Quoting::find_next_column_end(begin) - begin);
    const bool is_last = *end == '\0';
    *end = '\0';
    char* first = begin;
    char* last = end;
    io::trim_chars<' ', '\t'>::trim(first, last);
    Quoting::unescape(first, last);
    fields.emplace_back(first, last);
    if (is_last) return;
    begin = end + 1;
  }
}

}  // namespace

std::string CsvSource::at(unsigned line) const {
  return fmt::format("{}:{}: table '{}'", file, line, table);
}

std::string CsvSource::at(unsigned line, std::size_t column) const {
  return fmt::format("{}:{}:{}: table '{}'", file, line, column, table);
}

std::vector<CsvRow> csv_rows(const CsvSource& source, const std::string& text) {
  std::vector<CsvRow> rows;
  unsigned number = 0;
  for (const std::string_view line : sys::lines_of(text)) {
    ++number;
    if (sys::stripped(line).empty() || line.starts_with('#')) continue;
    std::vector<std::string> fields;
    try {
      split(std::string(line.substr(0, line.find('\0'))), fields);
    } catch (const io::error::escaped_string_not_closed&) {
      throw ImportError(
          fmt::format("{}: a quote is not closed", source.at(number, fields.size() + 1)));
    }
    if (line.find('\0') != line.npos) {
      throw ImportError(
          fmt::format("{}: the line holds a zero byte", source.at(number, fields.size())));
    }
    rows.push_back({number, std::move(fields)});
    const std::size_t n_expected = rows.front().fields.size();
    const std::size_t n_found = rows.back().fields.size();
    if (n_found == n_expected) continue;
    throw ImportError(fmt::format("{}: {} fields, where the first line has {}",
                                  source.at(number, std::min(n_found, n_expected) + 1), n_found,
                                  n_expected));
  }
  return rows;
}

}  // namespace literate
