// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "elasticity/surface_quadrature.hpp"
#include "paper/bounds.hpp"
#include "paper/conventions.hpp"
#include "paper/paper.hpp"
#include "paper/printed_data.hpp"

namespace paper {
namespace {

// K = 2(1−ν²)P/(πE): the displacement goes with K times the logarithm of the datum.
double scale_of(const HalfSpaceCase& c) {
  return c.material.integral_compliance() * c.load.line_load();
}

// What doubling the distance of the datum adds to every displacement.
double shift_of_doubling(const HalfSpaceCase& c) {
  return std::numbers::ln2 * scale_of(c);
}

// The sensitivity of u_z to the datum, by moving it and looking.
void measure_datum(Document& document, const HalfSpaceCase& c, const UnitSystem& units) {
  const double nearer = c.datum / 2;
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
  document.value("datum.doubling", Value(shift, scientific(3), units.length));
  document.value("datum.gradient", Value(at_datum, scientific(3)));
  document.value("datum.gradient-share",
                 Value(at_datum / gradient(c, c.load.half_width()), scientific(2)));
  // Far from the load the shift is that of a concentrated force; (a/datum)² is what is left.
  // But the datum may be so far that rounding leaves more.
  document.check(
      "datum-shifts-all-alike",
      {Criterion::at_most("largest less smallest shift, over the largest",
                          Value((largest - smallest) / largest, scientific(1).rounded_up()).as_is(),
                          {LimitKind::choice, 1e-12, "all are differences from the same datum"}),
       Criterion::agrees_relatively(
           "shift", Value(shift, scientific(3), units.length),
           Value(closed_form(shift_of_doubling(c)), scientific(3), units.length),
           Limit::theory("2(a/d)² + 2δ/s",
                         {{"a", c.load.half_width()},
                          {"d", nearer},
                          {"δ", shift.abs_error},
                          {"s", shift_of_doubling(c)}},
                         "d the nearer datum, and δ/s the rounding of displacements"))},
      "half the datum shifts every displacement by 2(1-nu^2)P/(pi E) ln 2");
}

void claim_datum(Document& document, const HalfSpaceCase& c,
                 const std::optional<PrintedData>& printed_data) {
  const elasticity::SurfaceQuadrature surface(c.material, c.load, c.datum);
  const elasticity::SurfaceQuadrature nearer(c.material, c.load, c.datum / 2);
  if (!printed_data) return;
  const double end = c.farthest_point();
  const Estimate displacement = surface.normal_displacement(end);
  const Estimate difference = abs(displacement - as_estimate(printed_data->figure5.fea_z.back()));
  const Estimate shift = abs(displacement - nearer.normal_displacement(end));
  document.claim(
      "insensitive-to-c",
      {.route = "the integral of eq. (2) by quadrature less the printed FEA (𝑧) at the last point, "
                "for the datum given and one at half of its distance, both far from the load",
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
          {LimitKind::choice, 2e-2,
           "far from the load its shape changes the slope by (𝑎/𝑥)²/6 if it is triangular and by "
           "(𝑎/𝑥)²/3 if it is uniform; the rest is left to the mesh of the run, which is not "
           "known"}));
    }
    return Criterion::in_each("load that follows from the slopes", "pairs of points", pairs);
  };
  document.claim(
      "same-load",
      {.route =
           "the printed columns: the slope of FEA (𝑧) over that of the analytical "
           "column at the outermost points, times 𝑝₀𝑎, for the same 𝐸 and ν; against the 𝑝₀𝑎 of "
           "eq. (4)",
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
  const double closing = c.datum * std::exp(-difference.value / scale_of(c));
  const double closing_error =
      rounded(closing) + closing * std::expm1(difference.abs_error / scale_of(c));
  const std::string& unit = units.length;
  std::vector<Criterion> of_order;
  for (const PrintedNumber& error : printed.error) {
    const double decades = std::abs(std::log10(error.value() / stated_order));
    const double unsure = error.last_place() / error.value();
    of_order.push_back(Criterion::at_most(
        "decades", Value({decades, unsure + rounded(decades)}, significant(2)),
        {LimitKind::choice, 0.5,
         "half a decade to either side of 10⁻⁷, as 10E-7 is read here; literally it is 10⁻⁶, which "
         "is more than any printed error"}));
  }
  document.claim(
      "order-of-error",
      {.route = "the printed error column",
       .expected = Verdict::partly,
       .criteria = {Criterion::in_each("distance from 10⁻⁷ in decades", "points", of_order)}});
  document.value("error.n-of-order", Value(n_holding(of_order), integer()));
  document.value("error.first", Value(first, scientific(2), unit));
  document.value("error.smallest", Value(smallest, scientific(2), unit));
  document.value("error.last", Value(last, scientific(2), unit));
  document.value("error.last-share", Value(last / fea, percent(0)));
  document.value("error.datum-that-closes-it",
                 Value(Estimate{closing, closing_error}, significant(2), unit));
  document.value("error.doubling-over-last",
                 Value(closed_form(shift_of_doubling(c)) / difference, percent(0)));
}

}  // namespace

void compute_error_analysis(Document& document, const Case& from) {
  const HalfSpaceCase& c = from.half_space;
  const UnitSystem& units = from.units;
  const std::optional<PrintedData>& printed_data = from.printed_data;
  measure_datum(document, c, units);
  claim_datum(document, c, printed_data);
  if (printed_data) {
    compare_error(document, c, units, *printed_data);
    compare_resultants(document, c, units, *printed_data);
  }
}

}  // namespace paper
