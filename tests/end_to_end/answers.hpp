// SPDX-License-Identifier: GPL-3.0-or-later
// What the commands answer, as numbers.
#pragma once

#include <cmath>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "program.hpp"
#include "system/text.hpp"

using nlohmann::json;

/// The words of a command line without quotes.
inline Words words_of(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

inline json json_of(const Words& command) {
  return json::parse(output_of(command + Words{"--format", "json"}));
}

/// The columns of a CSV under their headings, as texts.
using Columns = std::map<std::string, std::vector<std::string>>;

inline Columns csv_of(const Words& command) {
  const std::string text = output_of(command + Words{"--format", "csv"});
  const auto lines = sys::lines_of(text);
  const auto cells_of = [](std::string_view line) {
    std::vector<std::string> cells(1);
    for (const char c : line) {
      if (c == ',') {
        cells.emplace_back();
      } else {
        cells.back() += c;
      }
    }
    return cells;
  };
  const auto names = cells_of(lines.at(0));
  Columns columns;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const auto cells = cells_of(lines[i]);
    BOOST_TEST_REQUIRE(cells.size() == names.size());
    for (std::size_t j = 0; j < names.size(); ++j) columns[names[j]].push_back(cells[j]);
  }
  return columns;
}

inline double number(const std::string& cell) {
  return std::stod(cell);
}

inline double relative_difference(double a, double b) {
  return std::abs(a / b - 1);
}
