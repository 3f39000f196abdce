// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/displacement_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace app {
namespace {

using Rows = std::vector<DisplacementRow>;

template <class OfRow>
std::vector<double> numbers_of(const Rows& rows, const OfRow& of_row) {
  std::vector<double> numbers;
  for (const DisplacementRow& row : rows) numbers.push_back(of_row(row));
  return numbers;
}

// Of no rows there are the columns of rows with closed forms.
bool is_compared(const Rows& rows) {
  return rows.empty() || rows.front().gradient_closed_form;
}

// Adds the four columns of the gradient, or of the displacement.
void add_columns(std::vector<Column>& columns, const Rows& rows, const std::string& name,
                 const std::string& unit, numerics::Estimate DisplacementRow::*quadrature,
                 std::optional<double> DisplacementRow::*closed_form) {
  const bool is_absent = !is_compared(rows);
  const auto closed = [&](const auto& row) { return (row.*closed_form).value_or(0); };
  columns.push_back({name + "_quadrature",
                     {name + " by", "quadrature", unit},
                     22,
                     "{:.12e}",
                     numbers_of(rows, [&](const auto& row) { return (row.*quadrature).value; })});
  columns.push_back(
      {name + "_abs_error",
       {"error", "estimate", unit},
       10,
       "{:.1e}",
       numbers_of(rows, [&](const auto& row) { return (row.*quadrature).abs_error; })});
  columns.push_back({.key = name + "_closed_form",
                     .heads = {name + " in", "closed form", unit},
                     .width = 21,
                     .format = "{:.12e}",
                     .numbers = numbers_of(rows, closed),
                     .is_absent = is_absent});
  columns.push_back(
      {.key = "",
       .heads = {"difference", "over error", "[1]"},
       .width = 12,
       .format = "{:.2g}",
       .numbers = numbers_of(
           rows,
           [&](const auto& row) { return difference_over_error(row.*quadrature, closed(row)); }),
       .is_absent = is_absent});
}

bool agrees(const DisplacementRow& row) {
  return difference_over_error(row.gradient_quadrature, *row.gradient_closed_form) <= 1 &&
         difference_over_error(row.displacement_quadrature, *row.displacement_closed_form) <= 1;
}

std::string notes_text(const Rows& rows, const DisplacementNotes& notes) {
  std::string text;
  if (!rows.empty() && is_compared(rows)) {
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

Result displacement_result(const Rows& rows, const config::UnitSystem& units,
                           const DisplacementNotes& notes) {
  const std::string length = "[" + units.length + "]";
  std::vector<Column> columns = {
      {"x", {"x", "", length}, 12, "{}", numbers_of(rows, [](const auto& row) { return row.x; })}};
  add_columns(columns, rows, "gradient", "[1]", &DisplacementRow::gradient_quadrature,
              &DisplacementRow::gradient_closed_form);
  add_columns(columns, rows, "displacement", length, &DisplacementRow::displacement_quadrature,
              &DisplacementRow::displacement_closed_form);
  columns.push_back({.key = "",
                     .heads = {"evaluations", "of load", "[1]"},
                     .width = 12,
                     .format = "{:.0f}",
                     .numbers = numbers_of(rows, [](const auto& row) {
                       return static_cast<double>(row.n_evaluations);
                     })});
  return {
      .tables = {{std::move(columns)}}, .notes = notes_text(rows, notes), .script = "displacement"};
}

}  // namespace app
