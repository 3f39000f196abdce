// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/displacement_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <nlohmann/json.hpp>

#include "app/json_text.hpp"
#include "command_line/number_text.hpp"

namespace app {
namespace {

constexpr std::array column_names = {"x",
                                     "gradient_quadrature",
                                     "gradient_abs_error",
                                     "gradient_closed_form",
                                     "displacement_quadrature",
                                     "displacement_abs_error",
                                     "displacement_closed_form"};

// The numbers of a row in the order of the columns; throws sys::InputError for one that is not
// finite.
std::array<double, column_names.size()> numbers_of(const DisplacementRow& row) {
  const std::array<double, column_names.size()> numbers = {row.x,
                                                           row.gradient_quadrature.value,
                                                           row.gradient_quadrature.abs_error,
                                                           row.gradient_closed_form,
                                                           row.displacement_quadrature.value,
                                                           row.displacement_quadrature.abs_error,
                                                           row.displacement_closed_form};
  for (std::size_t i = 0; i < column_names.size(); ++i) {
    command_line::finite_result(fmt::format("{} at x = {}", column_names[i], row.x), numbers[i]);
  }
  return numbers;
}

}  // namespace

std::string displacement_csv(const std::vector<DisplacementRow>& rows) {
  std::string text = fmt::format("{}\n", fmt::join(column_names, ","));
  for (const DisplacementRow& row : rows)
    text += fmt::format("{}\n", fmt::join(numbers_of(row), ","));
  return text;
}

std::string displacement_json(const std::vector<DisplacementRow>& rows) {
  auto array = nlohmann::ordered_json::array();
  for (const DisplacementRow& row : rows) {
    nlohmann::ordered_json object;
    const auto numbers = numbers_of(row);
    for (std::size_t i = 0; i < column_names.size(); ++i) object[column_names[i]] = numbers[i];
    array.push_back(object);
  }
  return json_text(array);
}

std::string displacement_text(const std::vector<DisplacementRow>& rows,
                              const config::UnitSystem& units) {
  const auto line = [](auto&&... cells) {
    return fmt::format("{:>12}  {:>20} {:>9} {:>20}  {:>20} {:>9} {:>20}\n", cells...);
  };
  const std::string length = "[" + units.length + "]";
  std::string text = line("x", "gradient by", "error", "gradient in", "displacement by", "error",
                          "displacement in");
  text +=
      line("", "quadrature", "estimate", "closed form", "quadrature", "estimate", "closed form");
  text += line(length, "[1]", "[1]", "[1]", length, length, length);
  for (const DisplacementRow& row : rows) {
    const auto digits = [](double number) { return fmt::format("{:.12e}", number); };
    const auto rough = [](double number) { return fmt::format("{:.1e}", number); };
    const auto n = numbers_of(row);
    text += line(command_line::shortest(n[0]), digits(n[1]), rough(n[2]), digits(n[3]),
                 digits(n[4]), rough(n[5]), digits(n[6]));
  }
  return text;
}

}  // namespace app
