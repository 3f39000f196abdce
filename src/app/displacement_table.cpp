// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/displacement_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace app {
namespace {

using Rows = std::vector<DisplacementRow>;

// Of no rows there are the columns of rows with closed forms.
bool is_compared(const Rows& rows) {
  return rows.empty() || rows.front().gradient.closed_form;
}

// Adds the four columns of the gradient, or of the displacement.
void add_columns(std::vector<Column>& columns, const Rows& rows, const std::string& name,
                 const std::string& unit, BothWays DisplacementRow::*number) {
  columns.push_back(column_of(rows, name + "_quadrature", {name + " by", "quadrature", unit}, 22,
                              "{:.12e}",
                              [&](const auto& row) { return (row.*number).quadrature.value; }));
  columns.push_back(column_of(rows, name + "_abs_error", {"error", "estimate", unit}, 10, "{:.1e}",
                              [&](const auto& row) { return (row.*number).quadrature.abs_error; }));
  columns.push_back(
      column_of(rows, name + "_closed_form", {name + " in", "closed form", unit}, 21, "{:.12e}",
                [&](const auto& row) { return (row.*number).closed_form.value_or(0); }));
  columns.push_back(column_of(rows, "", {"difference", "over error", "[1]"}, 12, "{:.2g}",
                              [&](const auto& row) { return difference_over_error(row.*number); }));
  for (auto column = columns.end() - 2; column != columns.end(); ++column) {
    column->is_absent = !is_compared(rows);
  }
}

bool agrees(const DisplacementRow& row) {
  return difference_over_error(row.gradient) <= 1 && difference_over_error(row.displacement) <= 1;
}

std::string notes_text(const Rows& rows, const DisplacementNotes& notes) {
  std::string text;
  if (!rows.empty() && is_compared(rows)) {
    text = fmt::format("closed form: {}\n", notes.closed_form);
    text += fmt::format("{} of {} points agree within their errors",
                        std::count_if(rows.begin(), rows.end(), agrees), rows.size());
  } else {
    text = fmt::format("{} {} by quadrature; no closed form is known", rows.size(),
                       rows.size() == 1 ? "point" : "points");
  }
  long n_evaluations = 0;
  for (const DisplacementRow& row : rows) n_evaluations += row.n_evaluations;
  return text +
         fmt::format("; {} evaluations of the load, {:.3g} s\n", n_evaluations, notes.seconds);
}

}  // namespace

double difference_over_error(const BothWays& number) {
  const double closed_form = number.closed_form.value_or(number.quadrature.value);
  const double difference = std::abs(number.quadrature.value - closed_form);
  constexpr double roundings = 4 * std::numeric_limits<double>::epsilon();
  const double error = number.quadrature.abs_error + roundings * std::abs(closed_form);
  return difference == 0 ? 0 : difference / error;
}

Result displacement_result(const Rows& rows, const config::UnitSystem& units,
                           const DisplacementNotes& notes) {
  const std::string length = "[" + units.length + "]";
  std::vector<Column> columns = {
      column_of(rows, "x", {"x", "", length}, 12, "{}", [](const auto& row) { return row.x; })};
  add_columns(columns, rows, "gradient", "[1]", &DisplacementRow::gradient);
  add_columns(columns, rows, "displacement", length, &DisplacementRow::displacement);
  columns.push_back(
      column_of(rows, "", {"evaluations", "of load", "[1]"}, 12, "{:.0f}",
                [](const auto& row) { return static_cast<double>(row.n_evaluations); }));
  return {
      .tables = {{std::move(columns)}}, .notes = notes_text(rows, notes), .script = "displacement"};
}

}  // namespace app
