// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "command_line/options.hpp"

namespace app {
namespace {

using command_line::finite_result;
using nlohmann::ordered_json;

// Both zeros are printed without a sign.
double without_sign_of_zero(double number) {
  return number + 0.0;
}

bool is_for_programs(const Column& column) {
  return !column.key.empty() && !column.is_absent;
}

bool is_for_people(const Table& table) {
  return std::ranges::any_of(table.columns, [](const Column& c) { return !c.heads.empty(); });
}

std::size_t n_rows_of(const Table& table) {
  std::size_t n = 0;
  for (const Column& c : table.columns) n = std::max({n, c.numbers.size(), c.texts.size()});
  return n;
}

void require_finite(const Table& table) {
  const Column& first = table.columns.front();
  for (const Column& column : table.columns) {
    if (!is_for_programs(column) || column.may_be_infinite || !column.texts.empty()) continue;
    for (std::size_t i = 0; i < column.numbers.size(); ++i) {
      if (std::isfinite(column.numbers[i])) continue;
      finite_result(&column == &first ? column.key
                    : first.texts.empty()
                        ? fmt::format("{} at {} = {}", column.key, first.key, first.numbers[i])
                        : fmt::format("{} of {}", column.key, first.texts[i]),
                    column.numbers[i]);
    }
  }
}

void require_finite(const std::string& name, const ordered_json& value) {
  if (value.is_number_float()) finite_result(name, value.get<double>());
  if (!value.is_structured()) return;
  for (const auto& [key, element] : value.items()) {
    require_finite(value.is_object() ? key : name, element);
  }
}

bool is_flat(const ordered_json& value) {
  return std::ranges::none_of(value, [](const auto& element) { return element.is_structured(); });
}

std::string indented(const ordered_json& value, const std::string& indent) {
  if (value.is_number_float()) {
    return command_line::shortest(finite_result("a number of the JSON", value.get<double>()));
  }
  if (!value.is_structured()) return value.dump();
  const bool on_one_line = value.is_array() && is_flat(value);
  const std::string inner = on_one_line ? "" : "\n" + indent + "  ";
  std::string text;
  for (const auto& [key, element] : value.items()) {
    text += text.empty() ? inner : "," + (on_one_line ? std::string(" ") : inner);
    if (value.is_object()) text += ordered_json(key).dump() + ": ";
    text += indented(element, indent + "  ");
  }
  if (!on_one_line && !text.empty()) text += "\n" + indent;
  return value.is_object() ? "{" + text + "}" : "[" + text + "]";
}

// The cells of a row from the column `first` on.
ordered_json row_of(const Table& table, std::size_t i, std::size_t first) {
  ordered_json row = ordered_json::object();
  for (std::size_t k = first; k < table.columns.size(); ++k) {
    const Column& column = table.columns[k];
    if (!is_for_programs(column) || column.may_be_infinite) continue;
    if (column.texts.empty()) {
      row[column.key] = without_sign_of_zero(column.numbers[i]);
    } else {
      row[column.key] = column.texts[i];
    }
  }
  return row;
}

ordered_json rows_of(const Table& table) {
  ordered_json rows = ordered_json::array();
  for (std::size_t i = 0, n = n_rows_of(table); i < n; ++i) rows.push_back(row_of(table, i, 0));
  return rows;
}

// Several numbers under one name are an array.
void add(ordered_json& json, const std::string& name, double number) {
  if (!json.contains(name)) {
    json[name] = number;
    return;
  }
  ordered_json& value = json[name];
  if (!value.is_array()) value = ordered_json::array({value});
  value.push_back(number);
}

void add(ordered_json& json, const Table& table) {
  switch (table.in_json) {
    case InJson::no:
      break;
    case InJson::rows:
      json[table.name] = rows_of(table);
      break;
    case InJson::columns:
      for (const Column& column : table.columns) {
        if (!is_for_programs(column) || column.may_be_infinite) continue;
        std::vector<double> numbers = column.numbers;
        for (double& number : numbers) number = without_sign_of_zero(number);
        json[column.key] = numbers;
      }
      break;
    case InJson::by_text:
      for (std::size_t i = 0, n = n_rows_of(table); i < n; ++i) {
        json[table.name][table.columns[0].texts[i]] = row_of(table, i, 1);
      }
      break;
  }
}

std::string cell_of(const Column& column, std::size_t i) {
  if (column.is_absent) return "-";
  if (!column.texts.empty()) return column.texts[i];
  return fmt::format(fmt::runtime(column.format), without_sign_of_zero(column.numbers[i]));
}

std::string aligned(const Column& column, const std::string& cell) {
  return column.width < 0 ? fmt::format("{:<{}}", cell, -column.width)
                          : fmt::format("{:>{}}", cell, column.width);
}

std::string text_of(const Table& table) {
  std::string text;
  for (std::size_t line = 0; line < table.columns.front().heads.size(); ++line) {
    for (const Column& column : table.columns) text += aligned(column, column.heads[line]);
    text += '\n';
  }
  for (std::size_t i = 0, n = n_rows_of(table); i < n; ++i) {
    for (const Column& column : table.columns) text += aligned(column, cell_of(column, i));
    text += '\n';
  }
  return text;
}

std::string text_of(const Quantity& quantity) {
  const std::string begin = fmt::format("{:<22}{:>16.9g}", quantity.label, quantity.value);
  if (!quantity.exact) return fmt::format("{}  {}\n", begin, quantity.unit);
  const double exact = *quantity.exact;
  if (!std::isfinite(exact)) {
    return fmt::format("{}{:>16}  {:>10}  {}\n", begin, "infinite", "", quantity.unit);
  }
  return fmt::format("{}{:>16.9g}  {:>10.1e}  {}\n", begin, exact, quantity.value / exact - 1,
                     quantity.unit);
}

}  // namespace

void require_finite(const Result& result) {
  for (const Quantity& quantity : result.quantities) {
    finite_result(quantity.key.empty() ? quantity.label : quantity.key, quantity.value);
    if (quantity.exact) finite_result(quantity.key + " / exact", quantity.value / *quantity.exact);
  }
  require_finite("a number", result.details);
  for (const Table& table : result.tables) require_finite(table);
}

std::string csv_text(const Table& table) {
  std::vector<const Column*> columns;
  for (const Column& column : table.columns) {
    if (is_for_programs(column)) columns.push_back(&column);
  }
  std::string text;
  for (const Column* column : columns) text += (text.empty() ? "" : ",") + column->key;
  text += '\n';
  constexpr std::size_t usual_cell = 18;
  const std::size_t n_rows = n_rows_of(table);
  text.reserve(usual_cell * columns.size() * n_rows);
  for (std::size_t i = 0; i < n_rows; ++i) {
    for (const Column* column : columns) {
      if (column != columns.front()) text += ',';
      if (column->texts.empty()) {
        text += fmt::format("{}", without_sign_of_zero(column->numbers[i]));
      } else {
        text += column->texts[i];
      }
    }
    text += '\n';
  }
  return text;
}

std::string json_text(const ordered_json& value) {
  return indented(value, "") + "\n";
}

std::string json_of(const Result& result) {
  if (result.quantities.empty() && result.details.empty()) {
    return json_text(rows_of(result.tables.front()));
  }
  ordered_json json;
  ordered_json exact;
  for (const Quantity& quantity : result.quantities) {
    if (quantity.key.empty()) continue;
    add(json, quantity.key, quantity.value);
    if (quantity.exact && std::isfinite(*quantity.exact)) add(exact, quantity.key, *quantity.exact);
  }
  if (!result.details.empty()) json.update(result.details);
  if (!result.closed_form.empty()) json[result.closed_form] = exact;
  for (const Table& table : result.tables) add(json, table);
  return json_text(json);
}

std::string text_for_people(const Result& result) {
  std::string text;
  if (!result.closed_form.empty()) {
    text = fmt::format("{:<22}{:>16}{:>16}  {:>10}\n", "", "elements",
                       result.closed_form == "hertz" ? "Hertz" : "closed form", "difference");
  }
  for (const Quantity& quantity : result.quantities) text += text_of(quantity);
  for (const Table& table : result.tables) {
    if (is_for_people(table)) text += text_of(table);
  }
  return text + result.notes;
}

}  // namespace app
