// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/height_map_file.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <string_view>
#include <vector>

#include "command_line/number_text.hpp"
#include "system/files.hpp"
#include "system/lines.hpp"

namespace app {
namespace {

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
