// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "elasticity/surface_quadrature.hpp"
#include "paper/bounds.hpp"
#include "paper/conventions.hpp"
#include "paper/printed_data.hpp"
#include "paper/sections.hpp"

namespace paper {
namespace {

// What one factor e in the datum does to every displacement: 2(1−ν²)P/(πE).
double shift_per_e(const HalfSpaceCase& c) {
  return c.material.integral_compliance() * c.load.line_load();
}

// The sensitivity of u_z to the datum, by moving it and looking.
void measure_datum(Document& document, const HalfSpaceCase& c, const UnitSystem& units) {
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
  document.value("datum.gradient", Value(at_datum, scientific(3)));
  document.value("datum.gradient-share",
                 Value(at_datum / gradient(c, c.load.half_width()), scientific(2)));
  // Far from the load the shift is that of a concentrated force; (a/datum)² is what is left.
  // But the datum may be so far that rounding leaves more.
  const double left_over =
      2 * std::pow(c.load.half_width() / nearer, 2) + 2 * shift.abs_error / shift_per_e(c);
  document.check(
      "datum-shifts-all-alike",
      {Criterion::at_most("largest less smallest shift, over the largest",
                          Value((largest - smallest) / largest, scientific(1).rounded_up()).as_is(),
                          {LimitKind::rounding, 1e-12, "all are differences from the same datum"}),
       Criterion::agrees_relatively(
           "shift", Value(shift, scientific(3), units.length),
           Value(closed_form(shift_per_e(c)), scientific(3), units.length),
           {LimitKind::derived, left_over,
            "twice the square of a over the nearer datum, and the rounding of displacements"})},
      "a factor e in the datum shifts every displacement by 2(1-nu^2)P/(pi E)");
}

void claim_datum(Document& document, const HalfSpaceCase& c,
                 const std::optional<PrintedData>& printed_data) {
  const elasticity::SurfaceQuadrature surface(c.material, c.load, c.datum);
  const elasticity::SurfaceQuadrature nearer(c.material, c.load, c.datum / std::numbers::e);
  if (!printed_data) return;
  const double end = c.farthest_point();
  const Estimate displacement = surface.normal_displacement(end);
  const Estimate difference = abs(displacement - as_estimate(printed_data->figure5.fea_z.back()));
  const Estimate shift = abs(displacement - nearer.normal_displacement(end));
  document.claim(
      "insensitive-to-c",
      {.route = "eq. (2) by quadrature less the printed FEA (z) at the last point, for the "
                "datum given and one a factor e nearer, both far from the load",
       .expected = Verdict::refuted,
       .criteria = {Criterion::at_most("change of the error, over the error",
                                       Value(shift / difference, percent(0)),
                                       less_than_a_plot_shows())}});
  const Estimate at_datum = abs(surface.normal_gradient(c.datum));
  const Estimate at_end = abs(surface.normal_gradient(c.load.half_width()));
  document.claim("gradient-approaches-zero",
                 {.route = "eq. (2) by quadrature at the datum and at the end of the load",
                  .expected = Verdict::confirmed,
                  .criteria = {Criterion::at_most("gradient over that at the end of the load",
                                                  Value(at_datum / at_end, percent(2).rounded_up()),
                                                  less_than_a_plot_shows())}});
}

// u_x outside the load, which the paper calls negligible.
void measure_tangential(Document& document, const HalfSpaceCase& c, const UnitSystem& units) {
  // It is the same everywhere outside the load.
  const double end = std::max(c.farthest_point(), c.load.half_width());
  const Estimate u_x = closed_form(std::abs(tangential_displacement(c.material, c.load, end)));
  document.value("tangential.outside", Value(u_x, scientific(3), units.length));
  // Of u_z in the middle, which no datum makes zero.
  document.value("tangential.share", Value(u_x / displacement(c, 0), percent(0)));
  const elasticity::SurfaceQuadrature surface(c.material, c.load, c.datum);
  std::vector<Criterion> shares;
  for (const double x : c.points) {
    const Estimate by_quadrature = surface.tangential_displacement(x);
    const Estimate exact = closed_form(tangential_displacement(c.material, c.load, x));
    const double off = std::abs(by_quadrature.value - exact.value);
    const double allowed = by_quadrature.abs_error + exact.abs_error;
    shares.push_back(Criterion::at_most(
        "share", Value(allowed == 0 ? 0 : off / allowed, significant(1)).as_is(),
        {LimitKind::stated, 1.0, "the error that the quadrature reports, and rounding"}));
  }
  document.check("tangential-within-error",
                 {Criterion::in_each("difference over the errors of both", "points", shares)},
                 "u_x by quadrature is within its error of the closed form");
}

// u_x in the finite-element columns, √(magnitude² − z²), against u_z and against the half-space's.
void compare_tangential(Document& document, const HalfSpaceCase& c, const UnitSystem& units,
                        const PrintedData& printed_data) {
  const PrintedFigure5& printed = printed_data.figure5;
  const std::string& unit = units.length;
  Estimate largest_share, largest_excess;
  for (std::size_t i = 0; i < c.points.size(); ++i) {
    const Estimate u_z = as_estimate(printed.fea_z[i]);
    const Estimate share = other_component(printed.fea_magnitude[i], printed.fea_z[i]) / u_z;
    const Estimate excess = as_estimate(printed.fea_magnitude[i]) / u_z - 1;
    if (share.value > largest_share.value) largest_share = share;
    if (excess.value > largest_excess.value) largest_excess = excess;
  }
  const Limit negligible = nearly_identical();
  document.check("magnitude-like-z",
                 {Criterion::at_most("largest difference, over z",
                                     Value(largest_excess, percent(1).rounded_up()), negligible)},
                 "the printed magnitudes are nearly the displacements in the z-direction");
  document.claim("tangential-negligible",
                 {.route = "the 𝑥-displacement recovered from the printed magnitude and 𝑧",
                  .expected = Verdict::refuted,
                  .criteria = {Criterion::at_most("largest 𝑥-displacement, over 𝑧",
                                                  Value(largest_share, percent(0)), negligible)}});
  document.value("tangential.largest-excess", Value(largest_excess, percent(1)));
  document.value("tangential.largest-share", Value(largest_share, percent(0)));
  document.value("tangential.at-zero",
                 Value(other_component(printed.fea_magnitude.front(), printed.fea_z.front()),
                       scientific(2), unit));
  const Estimate half_space =
      closed_form(std::abs(tangential_displacement(c.material, c.load, c.farthest_point())));
  document.value("tangential.last-share",
                 Value(half_space / displacement(c, c.farthest_point()), percent(1)));
  const PrintedNumber& largest = printed_data.appendix2.measures.at("max_disp_x");
  document.value("tangential.max-disp-x", Value(as_estimate(largest), scientific(4), unit));
  document.value("tangential.max-disp-x-ratio", Value(as_estimate(largest) / half_space, fixed(2)));
}

// What the slopes far from the load tell of it: the load that is stated, and that of the summary.
void claim_resultant(Document& document, const HalfSpaceCase& c, const UnitSystem& units,
                     Estimate of_summary, const std::vector<Estimate>& slope_ratios) {
  const Estimate stated = closed_form(c.load.line_load());
  const std::string& unit = units.line_load;
  const auto each_agrees = [&](Estimate with) {
    std::vector<Criterion> pairs;
    for (const Estimate ratio : slope_ratios) {
      pairs.push_back(Criterion::agrees_relatively(
          "load", Value(stated.value * ratio, significant(3), unit),
          Value(with, significant(3), unit),
          {LimitKind::convention, 2e-2,
           "far from the load the influence of its shape is (𝑎/𝑥)²/6; the rest is for the mesh of "
           "the run, which is coarse there"}));
    }
    return Criterion::in_each("load that follows from the slopes", "pairs of points", pairs);
  };
  document.claim("same-load",
                 {.route = "the printed columns: the slope of FEA (z) over that of the analytical "
                           "column at the outermost points, times 𝑝₀𝑎; against the 𝑝₀𝑎 of eq. (4)",
                  .expected = Verdict::refuted,
                  .criteria = {each_agrees(stated)}});
  document.check("slopes-tell-the-load", {each_agrees(of_summary)},
                 "the slopes far from the load tell the resultant that the run reports");
}

// Far from the load the slope goes with the resultant; the printed columns tell which they had.
void compare_resultants(Document& document, const HalfSpaceCase& c, const UnitSystem& units,
                        const PrintedData& printed_data) {
  const Estimate resultant =
      abs(as_estimate(printed_data.appendix2.measures.at("resultant_load_y")));
  const auto slope = [&](const std::vector<PrintedNumber>& column, std::size_t i) {
    return 1 / (c.points[i] - c.points[i - 1]) *
           (as_estimate(column[i]) - as_estimate(column[i - 1]));
  };
  const Estimate loads = resultant / closed_form(c.load.line_load());
  Estimate least{HUGE_VAL, 0};
  Estimate most;
  std::vector<Estimate> ratios;
  for (std::size_t i = std::max<std::size_t>(5, c.points.size()) - 4; i < c.points.size(); ++i) {
    const Estimate ratio =
        slope(printed_data.figure5.fea_z, i) / slope(printed_data.figure5.analytical, i);
    ratios.push_back(ratio);
    if (ratio.value < least.value) least = ratio;
    if (ratio.value > most.value) most = ratio;
  }
  document.value("appendix2.resultant", Value(resultant, fixed(2), units.line_load));
  document.value("appendix2.resultant-ratio", Value(loads, fixed(2)));
  document.value("far-slope.n-points", Value(std::ssize(ratios) + 1, integer()));
  document.value("far-slope.least", Value(least, fixed(2)));
  document.value("far-slope.most", Value(most, fixed(2)));
  claim_resultant(document, c, units, resultant, ratios);
}

constexpr double stated_order = 1e-7;  // of the error, in words

// Which datum would have made the two columns meet at the last point.
void compare_error(Document& document, const HalfSpaceCase& c, const UnitSystem& units,
                   const PrintedData& printed_data) {
  const PrintedFigure5& printed = printed_data.figure5;
  const Estimate first = as_estimate(printed.error.front());
  const Estimate smallest = as_estimate(*std::ranges::min_element(
      printed.error, {}, [](const PrintedNumber& error) { return error.value(); }));
  const Estimate last = as_estimate(printed.error.back());
  const Estimate fea = as_estimate(printed.fea_z.back());
  const Estimate difference = displacement(c, c.farthest_point()) - fea;
  // The datum that would close a difference d is datum·exp(−d/K); it is as wrong as d/K,
  // relatively.
  const double closing = c.datum * std::exp(-difference.value / shift_per_e(c));
  const double closing_error =
      rounded(closing) + closing * std::expm1(difference.abs_error / shift_per_e(c));
  const std::string& unit = units.length;
  std::vector<Criterion> of_order;
  for (const PrintedNumber& error : printed.error) {
    const double decades = std::abs(std::log10(error.value() / stated_order));
    const double unsure = error.last_place() / error.value();
    of_order.push_back(Criterion::at_most(
        "decades", Value({decades, unsure + rounded(decades)}, significant(2)),
        {LimitKind::convention, 0.5,
         "half a decade to either side of 10⁻⁷, as 10E-7 is read here; literally it is 10⁻⁶, which "
         "is more than any printed error"}));
  }
  document.claim(
      "order-of-error",
      {.route = "the printed error column",
       .expected = Verdict::partly,
       .criteria = {Criterion::in_each("distance from 10⁻⁷ in decades", "points", of_order)}});
  document.value("error.first", Value(first, scientific(2), unit));
  document.value("error.smallest", Value(smallest, scientific(2), unit));
  document.value("error.last", Value(last, scientific(2), unit));
  document.value("error.last-share", Value(last / fea, percent(0)));
  document.value("error.datum-that-closes-it",
                 Value(Estimate{closing, closing_error}, significant(2), unit));
  document.value("error.shift-over-last",
                 Value(closed_form(shift_per_e(c)) / difference, percent(0)));
}

}  // namespace

void compute_error_analysis(Document& document, const Case& from) {
  const HalfSpaceCase& c = from.half_space;
  const UnitSystem& units = from.units;
  const std::optional<PrintedData>& printed_data = from.printed_data;
  measure_datum(document, c, units);
  claim_datum(document, c, printed_data);
  measure_tangential(document, c, units);
  if (printed_data) {
    compare_error(document, c, units, *printed_data);
    compare_resultants(document, c, units, *printed_data);
    compare_tangential(document, c, units, *printed_data);
  }
}

}  // namespace paper
