// SPDX-License-Identifier: GPL-3.0-or-later
// What every section of this report uses: names of the engine, of numbers with errors and of the
// parts of a case; limits and error bounds that several sections share.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "config/units.hpp"
#include "line_contact/cylinders.hpp"
#include "literate/document/document.hpp"
#include "numerics/estimate.hpp"
#include "parameters/case.hpp"
#include "parameters/printed_number.hpp"

namespace paper {

using config::UnitSystem;
using line_contact::Hertz;
using literate::Cell;
using literate::Column;
using literate::Criterion;
using literate::Document;
using literate::exact;
using literate::Figure;
using literate::FigureData;
using literate::fixed;
using literate::integer;
using literate::Limit;
using literate::LimitKind;
using literate::Number;
using literate::percent;
using literate::scientific;
using literate::significant;
using literate::uncertain;
using literate::Value;
using literate::Verdict;
using numerics::Estimate;
using parameters::BlockCase;
using parameters::ContactCase;
using parameters::HalfSpaceCase;
using parameters::PointContactCase;
using parameters::PrintedNumber;

/// A number with a standard uncertainty and no bound.
inline Number number_with(double value, double standard) {
  return {value, 0, standard};
}

/// A difference invisible in a plot: a hundredth of what it shows.
inline Limit less_than_a_plot_shows() {
  return Limit(1e-2, LimitKind::choice, "less than a plot shows");
}

/// The difference of two plotted curves that the paper calls nearly identical, or negligible.
inline Limit nearly_identical() {
  return Limit(3e-2, LimitKind::choice, "about what can be read off the axes of a plot");
}

/// Whether a fitted order of convergence is the expected one.
inline Criterion is_of_order(std::string what, const Number& order, double expected) {
  return Criterion::agrees(
      std::move(what), Value(order, uncertain()), Value(expected, exact()),
      Limit(0.25, LimitKind::choice, "nearer to the order stated than to any other multiple of 1/2")
          .counting(2));
}

/// A number for a table cell that prints its column's digits, whatever its error.
inline Estimate as_it_is(double number) {
  return {number, 0};
}

/// A printed number with an error of half a unit of its last place.
inline Estimate as_estimate(const PrintedNumber& number) {
  return {number.value(), number.last_place() / 2};
}
inline std::vector<double> values_of(const std::vector<PrintedNumber>& numbers) {
  std::vector<double> values;
  for (const PrintedNumber& number : numbers) values.push_back(number.value());
  return values;
}

/// u_z by eq. (3) and its gradient, with the accuracy stated in elasticity/loads.hpp.
Estimate displacement(const HalfSpaceCase& c, double x);
Estimate gradient(const HalfSpaceCase& c, double x);

/// K = 2(1−ν²)P/(πE), the scale of all normal displacements.
inline double displacement_scale(const HalfSpaceCase& c) {
  return c.material.integral_compliance() * c.load.line_load();
}

/// a/b − 1, in per cent: the deviation of the computed number a from the printed number b.
inline Estimate percent_off(Estimate a, const PrintedNumber& b) {
  return 100 * (a / as_estimate(b) - 1);
}

/// √(magnitude² − component²): the other component of a displacement from two printed numbers, with
/// the error from their last places.
Estimate other_component(const PrintedNumber& magnitude, const PrintedNumber& component);

/// A column of abscissae with the fewest decimals, at most nine, that print each of them exactly.
Column column_of_points(const std::vector<double>& points, const std::string& unit);
int decimals_of(const std::vector<double>& points);

}  // namespace paper
