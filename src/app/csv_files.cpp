// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/csv_files.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "command_line/options.hpp"
#include "system/csv.hpp"
#include "system/files.hpp"
#include "system/text.hpp"

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

// Where a field of a line begins, as editors count.
struct Place {
  const std::string& file;
  std::size_t line;
  std::size_t column;

  std::string text() const { return fmt::format("{}:{}:{}", file, line, column); }
};

double number_at(const Place& place, std::string_view field) {
  const std::string_view text = sys::stripped(field);
  if (text.empty()) {
    throw sys::InputError(place.text() + ": the grid has a gap: a number is missing here");
  }
  return command_line::parse_number(place.text(), std::string(text));
}

std::vector<double> numbers_of(const std::string& file, std::size_t line, std::string_view text) {
  std::vector<double> numbers;
  for (std::size_t begin = 0;;) {
    const std::size_t comma = text.find(',', begin);
    numbers.push_back(number_at({file, line, begin + 1}, text.substr(begin, comma - begin)));
    if (comma == std::string_view::npos) return numbers;
    begin = comma + 1;
  }
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

CsvColumns read_curve(const std::string& file, const std::string& first, const std::string& second,
                      std::size_t fewest) {
  CsvColumns points = read_columns(file, first, second);
  const std::vector<double>& x = points.first;
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (x[i] > x[i - 1]) continue;
    throw sys::InputError(fmt::format("{}:{}: {} = {}: must be greater than the one before, {}",
                                      file, points.lines[i], first, command_line::shortest(x[i]),
                                      command_line::shortest(x[i - 1])));
  }
  if (x.size() < fewest) {
    throw sys::InputError(
        fmt::format("{}: holds {} points, {} or more are needed", file, x.size(), fewest));
  }
  return points;
}

Eigen::ArrayXXd read_grid(const std::string& file) {
  if (std::filesystem::is_directory(file)) throw sys::InputError(file + ": is a folder");
  const std::string text = sys::read_file(file);
  std::vector<std::vector<double>> rows;
  std::size_t line = 0;
  std::size_t first_line = 0;
  for (const std::string_view full : sys::lines_of(text)) {
    ++line;
    const std::string_view stripped = sys::stripped(full);
    if (stripped.empty() || stripped.starts_with('#')) continue;
    rows.push_back(numbers_of(file, line, full));
    if (rows.size() == 1) first_line = line;
    if (rows.back().size() != rows.front().size()) {
      throw sys::InputError(fmt::format("{}:{}: holds {} numbers, line {} holds {}", file, line,
                                        rows.back().size(), first_line, rows.front().size()));
    }
  }
  constexpr std::size_t fewest = 4;
  const std::size_t width = rows.empty() ? 0 : rows.front().size();
  if (rows.size() < fewest || width < fewest) {
    throw sys::InputError(
        fmt::format("{}: holds {} lines of {} numbers, {} of {} or more are needed", file,
                    rows.size(), width, fewest, fewest));
  }
  Eigen::ArrayXXd grid(width, rows.size());
  for (std::size_t j = 0; j < rows.size(); ++j) {
    for (std::size_t i = 0; i < width; ++i) {
      grid(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = rows[j][i];
    }
  }
  return grid;
}

}  // namespace app
