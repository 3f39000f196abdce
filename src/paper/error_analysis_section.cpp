// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "elasticity/surface_quadrature.hpp"
#include "paper/decimals.hpp"
#include "paper/sections.hpp"

namespace paper {
namespace {

using literate::Column;
using literate::Value;

// What one factor e in the datum does to every displacement: 2(1−ν²)P/(πE).
double shift_per_e(const parameters::HalfSpaceCase& c) {
  return c.material.integral_compliance() * c.load.line_load();
}

// The sensitivity of u_z to the datum, by moving it and looking.
void measure_datum(literate::Document& document, const parameters::Case& from_file) {
  const parameters::HalfSpaceCase& c = from_file.half_space;
  const double nearer = c.datum / std::numbers::e;
  double largest = 0;
  double smallest = HUGE_VAL;
  for (const double x : c.points) {
    const double shift = normal_displacement(c.material, c.load, x, c.datum) -
                         normal_displacement(c.material, c.load, x, nearer);
    largest = std::max(largest, shift);
    smallest = std::min(smallest, shift);
  }
  document.value("datum.nearer", Value::significant(nearer, 3, from_file.units.length));
  document.value("datum.shift", Value::scientific(largest, 3, from_file.units.length));
  document.value("datum.shift-share",
                 Value::percent(largest / normal_displacement(c.material, c.load, 0, c.datum), 0));
  document.value("datum.gradient",
                 Value::scientific(normal_gradient(c.material, c.load, c.datum), 3));
  document.value("datum.gradient-share",
                 Value::scientific(normal_gradient(c.material, c.load, c.datum) /
                                       normal_gradient(c.material, c.load, c.load.half_width()),
                                   2));
  // Far from the load the shift is that of a concentrated force; (a/datum)² is what is left.
  const double left_over = 2 * std::pow(c.load.half_width() / nearer, 2);
  document.check(
      "datum-shifts-all-alike",
      largest - smallest <= 1e-12 * largest && std::abs(largest / shift_per_e(c) - 1) <= left_over,
      "a factor e in the datum shifts every displacement by 2(1-nu^2)P/(pi E)");
}

// u_x outside the load, which the paper calls negligible.
void measure_tangential(literate::Document& document, const parameters::Case& from_file) {
  const parameters::HalfSpaceCase& c = from_file.half_space;
  const double end = c.points.back();
  const double u_x = std::abs(tangential_displacement(c.material, c.load, end));
  document.value("tangential.outside", Value::scientific(u_x, 3, from_file.units.length));
  document.value("tangential.share",
                 Value::percent(u_x / normal_displacement(c.material, c.load, end, c.datum), 0));
  const elasticity::SurfaceQuadrature surface(c.material, c.load, c.datum);
  bool agrees = true;
  for (const double x : c.points) {
    const numerics::Estimate by_quadrature = surface.tangential_displacement(x);
    agrees =
        agrees && std::abs(by_quadrature.value - tangential_displacement(c.material, c.load, x)) <=
                      by_quadrature.abs_error;
  }
  document.check("tangential-within-error", agrees,
                 "u_x by quadrature of Johnson (2.24a) is within its error of the closed form");
}

// u_x in the finite-element columns, √(magnitude² − z²), beside the half-space's.
void compare_tangential(literate::Document& document, const parameters::Case& from_file) {
  const parameters::HalfSpaceCase& c = from_file.half_space;
  const parameters::PrintedFigure5& printed = from_file.printed->figure5;
  const std::string& unit = from_file.units.length;
  literate::Table table({Column::fixed("$x$", unit, decimals_of(c.points)),
                         Column::scaled("$\\sqrt{\\mathrm{mag}^2 - u_z^2}$, FEA", unit, -8, 2),
                         Column::scaled("$|u_x|$, half-space", unit, -8, 2),
                         Column::fixed("FEA $|u_x|/u_z$, \\%", "", 1)});
  double largest_share = 0;
  for (std::size_t i = 0; i < c.points.size(); ++i) {
    const double z = printed.fea_z[i].value();
    const double magnitude = printed.fea_magnitude[i].value();
    const double fea = std::sqrt((magnitude - z) * (magnitude + z));
    largest_share = std::max(largest_share, fea / z);
    table.add_row({c.points[i], fea,
                   std::abs(tangential_displacement(c.material, c.load, c.points[i])),
                   100 * fea / z});
  }
  document.table("tangential", table);
  const double z0 = printed.fea_z.front().value();
  const double magnitude0 = printed.fea_magnitude.front().value();
  document.value("tangential.at-zero",
                 Value::scientific(std::sqrt((magnitude0 - z0) * (magnitude0 + z0)), 2, unit));
  document.value("tangential.largest-share", Value::percent(largest_share, 0));
  const double largest = from_file.printed->appendix2.measures.at("max_disp_x").value();
  const double half_space = std::abs(tangential_displacement(c.material, c.load, c.points.back()));
  document.value("tangential.max-disp-x", Value::scientific(largest, 4, unit));
  document.value("tangential.max-disp-x-ratio", Value::fixed(largest / half_space, 2));
}

// Far from the load the slope goes with the resultant; the printed columns tell which they had.
void compare_resultants(literate::Document& document, const parameters::Case& from_file) {
  const parameters::HalfSpaceCase& c = from_file.half_space;
  const parameters::PrintedData& printed = *from_file.printed;
  const double resultant = std::abs(printed.appendix2.measures.at("resultant_load_y").value());
  const auto slope = [&](const std::vector<parameters::PrintedNumber>& column, std::size_t i) {
    return (column[i].value() - column[i - 1].value()) / (c.points[i] - c.points[i - 1]);
  };
  literate::Table table(
      {Column::text("between the points"), Column::common_exponent("slope, FEA ($z$)", "", 4),
       Column::common_exponent("slope, analytical", "", 4), Column::fixed("ratio", "", 3)});
  const int n_decimals = decimals_of(c.points);
  const double loads = resultant / c.load.line_load();
  double least = HUGE_VAL;
  double most = 0;
  for (std::size_t i = std::max<std::size_t>(5, c.points.size()) - 4; i < c.points.size(); ++i) {
    const double fea = slope(printed.figure5.fea_z, i);
    const double analytical = slope(printed.figure5.analytical, i);
    table.add_row({literate::Cell::latex(
                       Value::fixed(c.points[i - 1], n_decimals).latex() + " and " +
                       Value::fixed(c.points[i], n_decimals, from_file.units.length).latex()),
                   fea, analytical, fea / analytical});
    least = std::min(least, fea / analytical);
    most = std::max(most, fea / analytical);
  }
  document.table("far-slopes", table);
  const double gap = std::max(std::abs(least - loads), std::abs(most - loads)) / loads;
  document.value("appendix2.resultant", Value::fixed(resultant, 1, from_file.units.line_load));
  document.value("appendix2.resultant-ratio", Value::fixed(loads, 2));
  document.value("far-slope.least", Value::fixed(least, 2));
  document.value("far-slope.most", Value::fixed(most, 2));
  document.value("far-slope.gap", Value::percent_bound(gap, 1));
  document.check("fea-carried-another-load", least > 1.5,
                 "far from the load the printed FEA falls more than half again as fast as eq. (3)");
}

// Which datum would have made the two columns meet at the last point.
void compare_error(literate::Document& document, const parameters::Case& from_file) {
  const parameters::HalfSpaceCase& c = from_file.half_space;
  const parameters::PrintedFigure5& printed = from_file.printed->figure5;
  const double first = printed.error.front().value();
  const double last = printed.error.back().value();
  const double difference = normal_displacement(c.material, c.load, c.points.back(), c.datum) -
                            printed.fea_z.back().value();
  const std::string& unit = from_file.units.length;
  document.value("error.first", Value::scientific(first, 2, unit));
  document.value("error.last", Value::scientific(last, 2, unit));
  document.value("error.last-share", Value::percent(last / printed.fea_z.back().value(), 0));
  document.value("error.datum-that-closes-it",
                 Value::significant(c.datum * std::exp(-difference / shift_per_e(c)), 2, unit));
  document.value("error.shift-over-last", Value::percent(shift_per_e(c) / difference, 0));
}

}  // namespace

void compute_error_analysis(literate::Document& document, const parameters::Case& from_file) {
  measure_datum(document, from_file);
  measure_tangential(document, from_file);
  if (from_file.printed) {
    compare_error(document, from_file);
    compare_resultants(document, from_file);
    compare_tangential(document, from_file);
  }
}

}  // namespace paper
