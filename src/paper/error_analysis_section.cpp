// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <optional>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "elasticity/surface_quadrature.hpp"
#include "literate/document/document.hpp"
#include "paper/bounds.hpp"
#include "paper/decimals.hpp"
#include "paper/printed_data.hpp"
#include "paper/quoted.hpp"
#include "parameters/case.hpp"

namespace paper {
namespace {

using literate::Column;
using literate::confirmed_if;
using literate::fixed;
using literate::percent;
using literate::scientific;
using literate::significant;
using literate::Value;
using literate::Verdict;
using numerics::Estimate;

// What one factor e in the datum does to every displacement: 2(1−ν²)P/(πE).
double shift_per_e(const parameters::HalfSpaceCase& c) {
  return c.material.integral_compliance() * c.load.line_load();
}

// The sensitivity of u_z to the datum, by moving it and looking.
void measure_datum(literate::Document& document, const parameters::HalfSpaceCase& c,
                   const config::UnitSystem& units) {
  const double nearer = c.datum / std::numbers::e;
  double largest = 0;
  double smallest = HUGE_VAL;
  for (const double x : c.points) {
    const double shift = normal_displacement(c.material, c.load, x, c.datum) -
                         normal_displacement(c.material, c.load, x, nearer);
    largest = std::max(largest, shift);
    smallest = std::min(smallest, shift);
  }
  const Estimate middle = displacement(c, 0);
  const Estimate shift{largest, 2 * middle.abs_error};
  const Estimate at_datum = gradient(c, c.datum);
  document.value("datum.nearer", Value(closed_form(nearer), significant(3), units.length));
  document.value("datum.shift", Value(shift, scientific(3), units.length));
  document.value("datum.shift-share", Value(quotient(shift, middle), percent(0)));
  document.value("datum.gradient", Value(at_datum, scientific(3)));
  document.value("datum.gradient-share",
                 Value(quotient(at_datum, gradient(c, c.load.half_width())), scientific(2)));
  // Far from the load the shift is that of a concentrated force; (a/datum)² is what is left.
  const double left_over = 2 * std::pow(c.load.half_width() / nearer, 2);
  document.check(
      "datum-shifts-all-alike",
      largest - smallest <= 1e-12 * largest && std::abs(largest / shift_per_e(c) - 1) <= left_over,
      "a factor e in the datum shifts every displacement by 2(1-nu^2)P/(pi E)");
}

void claim_datum(literate::Document& document, const parameters::HalfSpaceCase& c,
                 const config::UnitSystem& units, const std::optional<PrintedData>& printed_data) {
  const elasticity::SurfaceQuadrature surface(c.material, c.load, c.datum);
  const elasticity::SurfaceQuadrature nearer(c.material, c.load, c.datum / std::numbers::e);
  const Estimate middle = surface.normal_displacement(0);
  const Estimate shift = magnitude(middle - nearer.normal_displacement(0));
  constexpr double insensitive = 1e-2;
  document.claim("insensitive-to-c",
                 {.sentence = "The error is not sensitive to C, provided that it was calculated a "
                              "distance far from the loaded region.",
                  .place = "paper, Error Analysis, p. 8",
                  .computed = Value(shift, scientific(3), units.length),
                  .route = "the displacement by quadrature for two datums, one a factor e nearer; "
                           "the value is the shift",
                  .tolerance = "1 % of the largest displacement, which would be lost in a plot",
                  .expected = Verdict::refuted,
                  .found = confirmed_if(shift.value < insensitive * middle.value)});
  if (!printed_data) return;
  // K/x is the gradient of the whole load put into a point: 1/x, whose integral has no limit.
  const Estimate at_datum = magnitude(surface.normal_gradient(c.datum));
  const double gradient = at_datum.value;
  const double largest = std::abs(surface.normal_gradient(c.load.half_width()).value);
  const bool is_small = gradient < insensitive * largest;
  const bool has_no_limit = std::abs(gradient * c.datum / shift_per_e(c) - 1) < 1e-3;
  const Verdict of_small = has_no_limit ? Verdict::partly : Verdict::confirmed;
  document.claim("gradient-approaches-zero",
                 {.sentence = "At x = 10 the displacement gradient approaches zero, so that C can "
                              "be evaluated there.",
                  .place = "paper, Results, p. 7",
                  .computed = Value(at_datum, scientific(3)),
                  .route = "eq. (2) by quadrature at the datum",
                  .tolerance = "small: below 1 % of the gradient at the end of the load; but "
                               "if it is K/x to 10⁻³, its integral has no limit, and C depends on "
                               "where it is evaluated",
                  .expected = Verdict::partly,
                  .found = is_small ? of_small : Verdict::refuted});
}

// u_x outside the load, which the paper calls negligible.
void measure_tangential(literate::Document& document, const parameters::HalfSpaceCase& c,
                        const config::UnitSystem& units) {
  const double end = c.farthest_point();
  const Estimate u_x = closed_form(std::abs(tangential_displacement(c.material, c.load, end)));
  document.value("tangential.outside", Value(u_x, scientific(3), units.length));
  document.value("tangential.share", Value(quotient(u_x, displacement(c, end)), percent(0)));
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

void claim_tangential(literate::Document& document, const PrintedData& printed_data,
                      Estimate largest_share) {
  const PrintedFigure5& printed = printed_data.figure5;
  double largest = 0;
  for (std::size_t i = 0; i < printed.x.size(); ++i) {
    largest = std::max(largest, printed.fea_magnitude[i].value() / printed.fea_z[i].value() - 1);
  }
  document.claim("magnitude-like-z",
                 {.sentence = "The finite-element displacements in the z-direction and their "
                              "magnitudes are nearly identical.",
                  .place = "paper, Error Analysis, p. 8",
                  .computed = Value(largest, percent(1).rounded_up()),
                  .route = "the printed columns; the value is their largest difference",
                  .tolerance = "2 %, the size of the marks in a plot like its Fig. 4",
                  .expected = Verdict::confirmed,
                  .found = confirmed_if(largest < 2e-2)});
  document.claim("tangential-negligible",
                 {.sentence = "This tells us that the displacements in the x-direction are "
                              "negligible.",
                  .place = "paper, Error Analysis, p. 8",
                  .computed = Value(largest_share, percent(0)),
                  .route = "the x-displacement recovered from the printed magnitude and z, over z",
                  .tolerance = "2 %, as for the magnitudes from which it is concluded",
                  .expected = Verdict::refuted,
                  .found = confirmed_if(largest_share.value < 2e-2)});
}

// √(magnitude² − z²) of two printed numbers, as far as their last places leave it open.
Estimate leg(const config::PrintedNumber& magnitude, const config::PrintedNumber& z) {
  const auto root = [](double difference, double sum) {
    return std::sqrt(std::max(0.0, difference) * sum);
  };
  const Estimate difference = as_estimate(magnitude) - as_estimate(z);
  const Estimate sum = as_estimate(magnitude) + as_estimate(z);
  const double value = root(difference.value, sum.value);
  const double least = root(difference.value - difference.abs_error, sum.value - sum.abs_error);
  const double most = root(difference.value + difference.abs_error, sum.value + sum.abs_error);
  return {value, std::max(value - least, most - value)};
}

// u_x in the finite-element columns, √(magnitude² − z²), beside the half-space's.
void compare_tangential(literate::Document& document, const parameters::HalfSpaceCase& c,
                        const config::UnitSystem& units, const PrintedData& printed_data) {
  const PrintedFigure5& printed = printed_data.figure5;
  const std::string& unit = units.length;
  literate::Table table(
      "tangential", {Column("$x$", fixed(decimals_of(c.points)), unit).exact(),
                     Column("$\\sqrt{\\mathrm{mag}^2 - u_z^2}$, FEA", fixed(2), unit).scaled(-8),
                     Column("$|u_x|$, half-space", fixed(2), unit).scaled(-8),
                     Column("FEA $|u_x|/u_z$, \\%", fixed(1))});
  Estimate largest_share;
  for (std::size_t i = 0; i < c.points.size(); ++i) {
    const Estimate fea = leg(printed.fea_magnitude[i], printed.fea_z[i]);
    const Estimate share = quotient(fea, as_estimate(printed.fea_z[i]));
    if (share.value > largest_share.value) largest_share = share;
    table.add_row({c.points[i], fea,
                   closed_form(std::abs(tangential_displacement(c.material, c.load, c.points[i]))),
                   100 * share});
  }
  document.table(table);
  claim_tangential(document, printed_data, largest_share);
  document.value(
      "tangential.at-zero",
      Value(leg(printed.fea_magnitude.front(), printed.fea_z.front()), scientific(2), unit));
  document.value("tangential.largest-share", Value(largest_share, percent(0)));
  const config::PrintedNumber& largest = printed_data.appendix2.measures.at("max_disp_x");
  const Estimate half_space =
      closed_form(std::abs(tangential_displacement(c.material, c.load, c.farthest_point())));
  document.value("tangential.max-disp-x", Value(as_estimate(largest), scientific(4), unit));
  document.value("tangential.max-disp-x-ratio",
                 Value(quotient(as_estimate(largest), half_space), fixed(2)));
}

// Of the whole load, by the printed slopes: that stated, and that of the run's summary.
void claim_resultants(literate::Document& document, const parameters::HalfSpaceCase& c,
                      const config::UnitSystem& units, const PrintedData& printed_data,
                      Estimate least, Estimate most) {
  const double stated = c.load.line_load();
  const config::PrintedNumber& summary = printed_data.appendix2.measures.at("resultant_load_y");
  const std::string& unit = units.line_load;
  // The slopes of the pairs of points differ by this much, of which their digits are the lesser
  // part.
  const Estimate found{stated * (least.value + most.value) / 2,
                       stated * ((most.value - least.value) / 2 + most.abs_error)};
  constexpr double of_slopes = 2e-2;
  const std::string route =
      "the printed columns: the slope of FEA (z) over that of the analytical column far from the "
      "load, times p₀a";
  const std::string tolerance =
      "2 %: the slopes of four pairs of points differ by less, and the shape of the load has died "
      "out there but for (a/x)²/6";
  document.claim("same-load",
                 {.sentence = "The finite-element model carries the same load distribution as the "
                              "analytical solution.",
                  .place = "paper, Numerical Solution, p. 6",
                  .stated = Value(stated, significant(3), unit),
                  .computed = Value(found, significant(3), unit),
                  .route = route,
                  .tolerance = tolerance,
                  .expected = Verdict::refuted,
                  .found = confirmed_if(std::abs(found.value / stated - 1) < of_slopes)});
  document.claim(
      "slopes-tell-the-load",
      {.sentence = "The slopes of the printed columns far from the load tell the "
                   "resultant that the run reports.",
       .place = "this report; paper, Appendix 2, p. 15",
       .stated = Value(std::abs(summary.value()), significant(3), unit),
       .computed = Value(found, significant(3), unit),
       .route = route,
       .tolerance = tolerance,
       .expected = Verdict::confirmed,
       .found = confirmed_if(std::abs(found.value / std::abs(summary.value()) - 1) < of_slopes)});
}

// Far from the load the slope goes with the resultant; the printed columns tell which they had.
void compare_resultants(literate::Document& document, const parameters::HalfSpaceCase& c,
                        const config::UnitSystem& units, const PrintedData& printed_data) {
  const Estimate resultant =
      magnitude(as_estimate(printed_data.appendix2.measures.at("resultant_load_y")));
  const auto slope = [&](const std::vector<config::PrintedNumber>& column, std::size_t i) {
    return 1 / (c.points[i] - c.points[i - 1]) *
           (as_estimate(column[i]) - as_estimate(column[i - 1]));
  };
  literate::Table table(
      "far-slopes",
      {Column::text("between the points"), Column("FEA ($z$)", significant(4)).under("slope"),
       Column("analytical", significant(4)).under("slope"), Column("ratio", fixed(3))});
  const int n_decimals = decimals_of(c.points);
  const Estimate loads = quotient(resultant, closed_form(c.load.line_load()));
  Estimate least{HUGE_VAL, 0};
  Estimate most;
  for (std::size_t i = std::max<std::size_t>(5, c.points.size()) - 4; i < c.points.size(); ++i) {
    const Estimate fea = slope(printed_data.figure5.fea_z, i);
    const Estimate analytical = slope(printed_data.figure5.analytical, i);
    const Estimate ratio = quotient(fea, analytical);
    table.add_row(
        {literate::Cell::latex(Value(c.points[i - 1], fixed(n_decimals)).latex() + " and " +
                               Value(c.points[i], fixed(n_decimals), units.length).latex()),
         fea, analytical, ratio});
    if (ratio.value < least.value) least = ratio;
    if (ratio.value > most.value) most = ratio;
  }
  document.table(table);
  const Estimate below = magnitude(least - loads);
  const Estimate above = magnitude(most - loads);
  const Estimate gap = quotient(below.value > above.value ? below : above, loads);
  document.value("appendix2.resultant", Value(resultant, fixed(1), units.line_load));
  document.value("appendix2.resultant-ratio", Value(loads, fixed(2)));
  claim_resultants(document, c, units, printed_data, least, most);
  document.value("far-slope.least", Value(least, fixed(2)));
  document.value("far-slope.most", Value(most, fixed(2)));
  document.value("far-slope.gap", Value(gap, percent(1).rounded_up()));
  document.check("fea-carried-another-load", least.value > 1.5,
                 "far from the load the printed FEA falls more than half again as fast as eq. (3)");
}

constexpr double stated_order = 1e-7;  // of the error, in words

// Which datum would have made the two columns meet at the last point.
void compare_error(literate::Document& document, const parameters::HalfSpaceCase& c,
                   const config::UnitSystem& units, const PrintedData& printed_data) {
  const PrintedFigure5& printed = printed_data.figure5;
  const Estimate first = as_estimate(printed.error.front());
  const Estimate last = as_estimate(printed.error.back());
  const Estimate fea = as_estimate(printed.fea_z.back());
  const Estimate difference = displacement(c, c.farthest_point()) - fea;
  // The datum that would close a difference d is datum·exp(−d/K); it is as wrong as d/K,
  // relatively.
  const double closing = c.datum * std::exp(-difference.value / shift_per_e(c));
  const double closing_error =
      rounded(closing) + closing * std::expm1(difference.abs_error / shift_per_e(c));
  const std::string& unit = units.length;
  const double decade = std::sqrt(10.0);
  const long n_of_order = std::ranges::count_if(printed.error, [&](const auto& error) {
    return error.value() > stated_order / decade && error.value() < stated_order * decade;
  });
  document.claim(
      "order-of-error",
      {.sentence = "The error remains in the order of 10E-7.",
       .place = "paper, Error Analysis, p. 8",
       .stated = Value::text("10E-7"),
       .computed = Value::text(fmt::format("{} of {} points", n_of_order, printed.error.size())),
       .route = "the printed error column",
       .tolerance = "from 10⁻⁷/√10 to 10⁻⁷√10, half a decade to either side of 10⁻⁷, which must be "
                    "meant: 10E-7 is 10⁻⁶, more than any of them",
       .expected = Verdict::partly,
       .found = literate::confirmed_in(n_of_order, std::ssize(printed.error))});
  document.value("error.first", Value(first, scientific(2), unit));
  document.value("error.last", Value(last, scientific(2), unit));
  document.value("error.last-share", Value(quotient(last, fea), percent(0)));
  document.value("error.datum-that-closes-it",
                 Value(Estimate{closing, closing_error}, significant(2), unit));
  document.value("error.shift-over-last",
                 Value(quotient(closed_form(shift_per_e(c)), difference), percent(0)));
}

}  // namespace

void compute_error_analysis(literate::Document& document, const parameters::HalfSpaceCase& c,
                            const config::UnitSystem& units,
                            const std::optional<PrintedData>& printed_data) {
  measure_datum(document, c, units);
  claim_datum(document, c, units, printed_data);
  measure_tangential(document, c, units);
  if (printed_data) {
    compare_error(document, c, units, *printed_data);
    compare_resultants(document, c, units, *printed_data);
    compare_tangential(document, c, units, *printed_data);
  }
}

}  // namespace paper
