// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "app/flags.hpp"

namespace app {
namespace {

// Without an allocation per number, a million take a tenth of a second. Adding 0 drops the sign of
// a zero.
void append(std::string& text, double number) {
  std::array<char, 32> digits;
  const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), number + 0.0);
  text.append(digits.data(), result.ptr);
}

void append_json(std::string& text, double number) {
  if (std::isfinite(number)) {
    append(text, number);
  } else {
    text += "null";
  }
}

void append_json(std::string& text, const std::vector<double>& numbers) {
  text += '[';
  for (const double& number : numbers) {
    if (&number != numbers.data()) text += ", ";
    append_json(text, number);
  }
  text += ']';
}

// nlohmann's own dump() misses the shortest digits about once in a thousand numbers.
void append_json(std::string& text, const Json& value, const std::string& indent) {
  if (value.is_number_float()) return append_json(text, value.get<double>());
  if (!value.is_structured()) {
    text += value.dump();
    return;
  }
  if (value.is_array() && !value.empty() && value[0].is_number()) {
    return append_json(text, value.get<std::vector<double>>());
  }
  const bool is_on_one_line = !value.empty() && value.front().is_string();  // the units
  const std::string separator = is_on_one_line ? " " : "\n" + indent + "  ";
  text += value.is_object() ? '{' : '[';
  bool is_first = true;
  for (const auto& [key, element] : value.items()) {
    if (!is_first) text += ',';
    if (!is_first || !is_on_one_line) text += separator;
    if (value.is_object()) text += Json(key).dump() + ": ";
    append_json(text, element, indent + "  ");
    is_first = false;
  }
  if (!is_first && !is_on_one_line) text += "\n" + indent;
  text += value.is_object() ? '}' : ']';
}

std::size_t n_rows_of(const Table& table) {
  std::size_t n = 0;
  for (const Column& column : table) n = std::max({n, column.numbers.size(), column.cells.size()});
  return n;
}

Table table_of(const Result& result) {
  Column labels{.key = "", .heads = {""}};
  Column values{.key = "", .heads = {"elements"}, .numbers = {0}};
  Column exact{.key = "", .heads = {result.is_hertz ? "Hertz" : ""}, .numbers = {0}};
  Column differences{.key = "", .heads = {result.is_hertz ? "difference" : ""}, .numbers = {0}};
  for (const Quantity& quantity : result.quantities) {
    labels.cells.push_back(fmt::format("{} ({})", quantity.label, quantity.unit));
    values.cells.push_back(fmt::format("{:.{}g}", quantity.value, result.digits));
    exact.cells.emplace_back();
    differences.cells.emplace_back();
    if (!quantity.exact) continue;
    exact.cells.back() = fmt::format("{:.7g}", *quantity.exact);
    const double percent = 100 * std::abs(quantity.value / *quantity.exact - 1);
    constexpr double rounding = 1e-10;
    differences.cells.back() = fmt::format("{:.1g} %", percent < rounding ? 0 : percent);
  }
  return {labels, values, exact, differences};
}

std::string text_of(const Table& table) {
  std::vector<std::string> lines;
  for (const Column& column : table) {
    if (column.heads.empty()) continue;
    std::vector<std::string> cells = column.heads;
    cells.insert(cells.end(), column.cells.begin(), column.cells.end());
    lines.resize(cells.size());
    std::size_t width = 0;
    for (const std::string& cell : cells) width = std::max(width, cell.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (&column != table.data()) lines[i] += "  ";
      lines[i] += column.numbers.empty() ? fmt::format("{:<{}}", cells[i], width)
                                         : fmt::format("{:>{}}", cells[i], width);
    }
  }
  std::string text;
  for (const std::string& line : lines)
    text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
  return text;
}

// Two numbers with one key form an array.
void add(Json& json, const std::string& key, double number) {
  if (json.contains(key)) {
    json[key] = {json[key], number};
  } else {
    json[key] = number;
  }
}

Json rows_of(const Result& result) {
  Json rows = Json::array();
  for (std::size_t i = 0, n = n_rows_of(result.table); i < n; ++i) {
    rows.emplace_back();
    for (const Column& column : result.table) {
      if (!column.key.empty()) rows.back()[column.key] = column.numbers[i];
    }
    rows.back()["units"] = result.units;
  }
  return rows;
}

}  // namespace

Column aligned_column(const std::string& key, const std::vector<std::string>& heads,
                      const std::string& unit, std::vector<double> numbers, double largest,
                      int digits) {
  const int place = largest > 0 ? static_cast<int>(std::floor(std::log10(largest))) : 0;
  constexpr int least_place = -2, greatest_place = 5;
  const bool is_scaled = place < least_place || place > greatest_place;
  const int exponent = is_scaled ? 3 * static_cast<int>(std::floor(place / 3.0)) : 0;
  const double factor = std::pow(10.0, -exponent);
  const int n_decimals = std::max(0, digits - 1 - (place - exponent));

  const std::string power = is_scaled ? fmt::format("1e{}", exponent) : "";
  const bool is_alone = is_scaled && unit == "1";
  Column column{.key = key, .heads = heads, .numbers = std::move(numbers)};
  column.heads.push_back("[" + power + (is_alone ? "" : is_scaled ? " " + unit : unit) + "]");
  for (const double number : column.numbers) {
    std::string cell = fmt::format("{:.{}f}", number * factor, n_decimals);
    if (cell.find_first_of("123456789") == std::string::npos && cell[0] == '-') cell.erase(0, 1);
    if (std::isinf(number)) cell = number < 0 ? "-infinite" : "infinite";
    if (std::isnan(number)) cell = "no limit";
    column.cells.push_back(cell);
  }
  return column;
}

double greatest(const std::vector<double>& numbers) {
  double greatest = 0;
  for (const double number : numbers) {
    if (std::isfinite(number)) greatest = std::max(greatest, std::abs(number));
  }
  return greatest;
}

Column column_of_places(const std::string& key, const std::string& unit,
                        std::vector<double> numbers) {
  Column column{.key = key, .heads = {key, "", "[" + unit + "]"}, .numbers = std::move(numbers)};
  for (const double number : column.numbers) column.cells.push_back(rounded(number));
  return column;
}

int earned_digits(double rel_error, int most) {
  constexpr double fewest = 3;
  if (!(rel_error > 0)) return most;
  return static_cast<int>(std::clamp(std::ceil(-std::log10(rel_error)), fewest, double(most)));
}

std::string text_of(const Result& result) {
  std::string text = result.quantities.empty() ? "" : text_of(table_of(result));
  text += text_of(result.table);
  for (const std::string& note : result.notes) text += note + '\n';
  return text;
}

std::string csv_of(const Table& table) {
  std::string text;
  std::vector<const Column*> columns;
  for (const Column& column : table) {
    if (column.key.empty()) continue;
    text += (columns.empty() ? "" : ",") + column.key;
    columns.push_back(&column);
  }
  text += '\n';
  constexpr std::size_t usual_cell = 22;
  const std::size_t n_rows = n_rows_of(table);
  text.reserve(text.size() + usual_cell * columns.size() * n_rows);
  for (std::size_t i = 0; i < n_rows; ++i) {
    for (const Column* column : columns) {
      if (column != columns.front()) text += ',';
      if (column->numbers.empty()) {
        text += column->cells[i];
      } else {
        append(text, column->numbers[i]);
      }
    }
    text += '\n';
  }
  return text;
}

std::string json_of(const Result& result) {
  std::string text;
  if (result.quantities.empty() && result.details.empty()) {
    append_json(text, rows_of(result), "");
    text += '\n';
    return text;
  }
  Json json, hertz;
  for (const Quantity& quantity : result.quantities) {
    add(json, quantity.key, quantity.value);
    if (quantity.exact) add(hertz, quantity.key, *quantity.exact);
  }
  if (result.is_hertz) json["hertz"] = hertz;
  json.update(result.details);
  json["units"] = result.units;
  append_json(text, json, "");
  // Columns may be long, so they bypass the tree of values.
  constexpr std::size_t usual_number = 22;
  text.resize(text.size() - 2);
  text.reserve(text.size() + usual_number * result.table.size() * n_rows_of(result.table));
  for (const Column& column : result.table) {
    text += fmt::format(",\n  \"{}\": ", column.key);
    append_json(text, column.numbers);
  }
  text += "\n}";
  text += '\n';
  return text;
}

std::vector<double> to_vector(const Eigen::VectorXd& numbers) {
  return {numbers.data(), numbers.data() + numbers.size()};
}

}  // namespace app
