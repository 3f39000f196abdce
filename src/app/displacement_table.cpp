// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/displacement_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/json_text.hpp"
#include "command_line/number_text.hpp"

namespace app {
namespace {

struct Column {
  const char* name;
  double number;
};

// The numbers of a row in the order of the columns; throws sys::InputError for one that is not
// finite.
std::vector<Column> columns_of(const DisplacementRow& row) {
  std::vector<Column> columns{{"x", row.x},
                              {"gradient_quadrature", row.gradient_quadrature.value},
                              {"gradient_abs_error", row.gradient_quadrature.abs_error}};
  if (row.gradient_closed_form) {
    columns.push_back({"gradient_closed_form", *row.gradient_closed_form});
  }
  columns.push_back({"displacement_quadrature", row.displacement_quadrature.value});
  columns.push_back({"displacement_abs_error", row.displacement_quadrature.abs_error});
  if (row.displacement_closed_form) {
    columns.push_back({"displacement_closed_form", *row.displacement_closed_form});
  }
  for (Column& column : columns) {
    command_line::finite_result(fmt::format("{} at x = {}", column.name, row.x), column.number);
    column.number += 0.0;  // no -0
  }
  return columns;
}

// The names of the columns; of no rows those of a row with closed forms.
std::vector<std::string> names_of(const std::vector<DisplacementRow>& rows) {
  const DisplacementRow with_closed_forms{0, {}, 0, {}, 0};
  std::vector<std::string> names;
  for (const Column& column : columns_of(rows.empty() ? with_closed_forms : rows.front())) {
    names.emplace_back(column.name);
  }
  return names;
}

bool agrees(const DisplacementRow& row) {
  return difference_over_error(row.gradient_quadrature, *row.gradient_closed_form) <= 1 &&
         difference_over_error(row.displacement_quadrature, *row.displacement_closed_form) <= 1;
}

std::string notes_text(const std::vector<DisplacementRow>& rows, const DisplacementNotes& notes) {
  const bool is_compared = !rows.empty() && rows.front().gradient_closed_form;
  std::string text;
  if (is_compared) {
    text = fmt::format("beside eq. (2) by quadrature stands {}\n", notes.closed_form);
    text += fmt::format("{} of {} points agree within their errors",
                        std::count_if(rows.begin(), rows.end(), agrees), rows.size());
  } else {
    text = fmt::format("{} points by quadrature, which no closed form stands beside", rows.size());
  }
  long n_evaluations = 0;
  for (const DisplacementRow& row : rows) n_evaluations += row.n_evaluations;
  return text +
         fmt::format("; {} evaluations of the load, {:.3g} s\n", n_evaluations, notes.seconds);
}

}  // namespace

double difference_over_error(const numerics::Estimate& quadrature, double closed_form) {
  const double difference = std::abs(quadrature.value - closed_form);
  constexpr double roundings = 4 * std::numeric_limits<double>::epsilon();
  return difference == 0 ? 0
                         : difference / (quadrature.abs_error + roundings * std::abs(closed_form));
}

std::string displacement_csv(const std::vector<DisplacementRow>& rows) {
  std::string text = fmt::format("{}\n", fmt::join(names_of(rows), ","));
  for (const DisplacementRow& row : rows) {
    std::vector<double> numbers;
    for (const Column& column : columns_of(row)) numbers.push_back(column.number);
    text += fmt::format("{}\n", fmt::join(numbers, ","));
  }
  return text;
}

std::string displacement_json(const std::vector<DisplacementRow>& rows) {
  auto array = nlohmann::ordered_json::array();
  for (const DisplacementRow& row : rows) {
    nlohmann::ordered_json object;
    for (const Column& column : columns_of(row)) object[column.name] = column.number;
    array.push_back(object);
  }
  return json_text(array);
}

std::string displacement_text(const std::vector<DisplacementRow>& rows,
                              const config::UnitSystem& units, const DisplacementNotes& notes) {
  const auto line = [](auto&&... cells) {
    return fmt::format("{:>12}  {:>20} {:>9} {:>20} {:>11}  {:>20} {:>9} {:>20} {:>11} {:>11}\n",
                       cells...);
  };
  const std::string length = "[" + units.length + "]";
  std::string text =
      line("x", "gradient by", "error", "gradient in", "difference", "displacement by", "error",
           "displacement in", "difference", "evaluations");
  text += line("", "quadrature", "estimate", "closed form", "over error", "quadrature", "estimate",
               "closed form", "over error", "of load");
  text += line(length, "[1]", "[1]", "[1]", "[1]", length, length, length, "[1]", "[1]");
  for (const DisplacementRow& row : rows) {
    columns_of(row);  // finite
    const auto digits = [](double number) { return fmt::format("{:.12e}", number + 0.0); };
    const auto rough = [](double number) { return fmt::format("{:.1e}", number); };
    const auto closed = [&](const std::optional<double>& number) {
      return number ? digits(*number) : std::string("-");
    };
    const auto ratio = [](const numerics::Estimate& estimate, const std::optional<double>& exact) {
      return exact ? fmt::format("{:.2g}", difference_over_error(estimate, *exact))
                   : std::string("-");
    };
    const numerics::Estimate& gradient = row.gradient_quadrature;
    const numerics::Estimate& displacement = row.displacement_quadrature;
    text += line(command_line::shortest(row.x + 0.0), digits(gradient.value),
                 rough(gradient.abs_error), closed(row.gradient_closed_form),
                 ratio(gradient, row.gradient_closed_form), digits(displacement.value),
                 rough(displacement.abs_error), closed(row.displacement_closed_form),
                 ratio(displacement, row.displacement_closed_form), row.n_evaluations);
  }
  return text + notes_text(rows, notes);
}

}  // namespace app
