// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/csv_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <span>
#include <string_view>

#include "app/flags.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/text.hpp"

namespace app {
namespace {

struct Line {
  std::size_t number;  // in the file, from 1
  std::string_view text;
};

std::vector<Line> lines_of(const std::string& text) {
  std::vector<Line> lines;
  std::size_t number = 0;
  for (const std::string_view line : sys::lines_of(text)) {
    ++number;
    const std::string_view stripped = sys::stripped(line);
    if (!stripped.empty() && !stripped.starts_with('#')) lines.push_back({number, line});
  }
  return lines;
}

std::string text_of(const std::string& file) {
  if (std::filesystem::is_directory(file)) throw sys::InputError(file + ": is a folder");
  std::string text = sys::read_file(file);
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";  // written by spreadsheets
  if (text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
  return text;
}

std::vector<double> numbers_of(const std::string& file, const Line& line) {
  std::vector<double> numbers;
  for (std::size_t begin = 0;;) {
    const std::size_t comma = line.text.find(',', begin);
    const std::string number(sys::stripped(line.text.substr(begin, comma - begin)));
    const std::string place = fmt::format("{}:{}:{}", file, line.number, begin + 1);
    if (number.empty()) throw sys::InputError(place + ": a number is missing");
    numbers.push_back(parse_number(place, number));
    if (comma == std::string_view::npos) return numbers;
    begin = comma + 1;
  }
}

}  // namespace

CurvePoints read_curve(const std::string& file, const std::string& heading, std::size_t fewest) {
  const std::string text = text_of(file);
  const std::vector<Line> lines = lines_of(text);
  std::string found(lines.empty() ? "" : sys::stripped(lines[0].text));
  std::erase(found, ' ');
  if (found != heading) {
    throw sys::InputError(fmt::format("{}:{}: the heading must be {}", file,
                                      lines.empty() ? 1 : lines[0].number, heading));
  }
  CurvePoints points;
  for (const Line& line : std::span(lines).subspan(1)) {
    const std::vector<double> numbers = numbers_of(file, line);
    if (numbers.size() != 2) {
      throw sys::InputError(fmt::format("{}:{}: expected 2 numbers ({}), found {}", file,
                                        line.number, heading, numbers.size()));
    }
    if (!points.x.empty() && !(numbers[0] > points.x.back())) {
      throw sys::InputError(fmt::format("{}:{}: x = {}: must be greater than the x before it, {}",
                                        file, line.number, numbers[0], points.x.back()));
    }
    points.x.push_back(numbers[0]);
    points.y.push_back(numbers[1]);
  }
  if (points.x.size() < fewest) {
    throw sys::InputError(
        fmt::format("{}: expected at least {} points, found {}", file, fewest, points.x.size()));
  }
  return points;
}

Eigen::ArrayXXd read_grid(const std::string& file) {
  const std::string text = text_of(file);
  const std::vector<Line> lines = lines_of(text);
  std::vector<std::vector<double>> rows;
  for (const Line& line : lines) {
    rows.push_back(numbers_of(file, line));
    if (rows.back().size() != rows.front().size()) {
      throw sys::InputError(fmt::format("{}:{}: expected {} numbers as in line {}, found {}", file,
                                        line.number, rows[0].size(), lines[0].number,
                                        rows.back().size()));
    }
  }
  constexpr std::size_t fewest = 4;
  const std::size_t width = rows.empty() ? 0 : rows[0].size();
  if (rows.size() < fewest || width < fewest) {
    throw sys::InputError(
        fmt::format("{}: expected at least {} lines of {} numbers, found {} of {}", file, fewest,
                    fewest, rows.size(), width));
  }
  Eigen::ArrayXXd grid(width, rows.size());
  for (std::size_t j = 0; j < rows.size(); ++j) {
    grid.col(static_cast<Eigen::Index>(j)) =
        Eigen::Map<const Eigen::ArrayXd>(rows[j].data(), static_cast<Eigen::Index>(width));
  }
  return grid;
}

}  // namespace app
