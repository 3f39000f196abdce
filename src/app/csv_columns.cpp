// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/csv_columns.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "command_line/number_text.hpp"
#include "system/csv.hpp"
#include "system/files.hpp"

namespace app {
namespace {

std::size_t index_of(const sys::CsvRow& headings, const std::string& name, const std::string& file,
                     const std::string& wanted) {
  const auto heading = std::ranges::find(headings, name, &sys::CsvField::text);
  if (heading == headings.end()) {
    throw sys::InputError(
        fmt::format("{}:{}: the heading must be {}", file, headings[0].line, wanted));
  }
  return static_cast<std::size_t>(heading - headings.begin());
}

}  // namespace

CsvColumns read_columns(const std::string& file, const std::string& first,
                        const std::string& second) {
  const auto rows = sys::parse_csv(sys::read_file(file), file, sys::CsvComments::number_sign);
  const std::string wanted = first + "," + second;
  if (rows.empty())
    throw sys::InputError(fmt::format("{}:1: the heading must be {}", file, wanted));
  const std::size_t i_first = index_of(rows[0], first, file, wanted);
  const std::size_t i_second = index_of(rows[0], second, file, wanted);
  CsvColumns columns;
  for (auto row = rows.begin() + 1; row != rows.end(); ++row) {
    const std::string place = fmt::format("{}:{}: ", file, row->front().line);
    columns.first.push_back(command_line::parse_number(place + first, (*row)[i_first].text));
    columns.second.push_back(command_line::parse_number(place + second, (*row)[i_second].text));
    columns.lines.push_back(row->front().line);
  }
  return columns;
}

}  // namespace app
