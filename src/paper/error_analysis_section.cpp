// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "elasticity/loads.hpp"
#include "elasticity/surface_quadrature.hpp"
#include "paper/conventions.hpp"
#include "paper/paper.hpp"

namespace paper {
namespace {

// The increase of every displacement near the load if the distance of the datum is doubled.
double shift_of_doubling(const HalfSpaceCase& c) {
  return normal_displacement(c.material, c.load, 0, c.datum) -
         normal_displacement(c.material, c.load, 0, c.datum / 2);
}

void claim_datum(Document& document, const HalfSpaceCase& c, const PrintedData& printed) {
  const elasticity::SurfaceQuadrature surface(c.material, c.load, c.datum);
  const elasticity::SurfaceQuadrature nearer(c.material, c.load, c.datum / 2);
  const double end = c.farthest_point();
  const Estimate displacement = surface.normal_displacement(end);
  const Estimate difference = abs(displacement - as_estimate(printed.figure5.fea_z.back()));
  const Estimate shift = abs(displacement - nearer.normal_displacement(end));
  document.claim(
      "insensitive-to-c",
      {.route = "eq.~(2) by quadrature minus the printed FEA $z$ at the last point, for the given "
                "datum and for one at half its distance",
       .expected = Verdict::fails,
       .criteria = {Criterion::at_most("change of the error over the error",
                                       Value(shift / difference, percent(0)),
                                       less_than_a_plot_shows())}});
}

// The ratio of the two printed columns' slopes between neighbours among the last points. Far from
// the load the slope depends only on the resultant.
std::vector<Estimate> slope_ratios(const PrintedFigure5& printed) {
  constexpr std::size_t n_last = 5;
  std::vector<Estimate> ratios;
  for (std::size_t i = std::max(n_last, printed.x.size()) - n_last + 1; i < printed.x.size(); ++i) {
    const auto fall = [i](const std::vector<PrintedNumber>& column) {
      return as_estimate(column[i]) - as_estimate(column[i - 1]);
    };
    ratios.push_back(fall(printed.fea_z) / fall(printed.analytical));
  }
  return ratios;
}

void compare_resultants(Document& document, const HalfSpaceCase& c, const UnitSystem& units,
                        const PrintedData& printed) {
  const Estimate resultant = abs(as_estimate(measure(printed, "resultant_load_y")));
  const double stated = c.load.line_load();
  const std::vector<Estimate> ratios = slope_ratios(printed.figure5);
  const auto [least, most] = std::ranges::minmax(ratios, {}, &Estimate::value);
  document.value("appendix2.resultant", Value(resultant, fixed(2), units.line_load));
  document.value("appendix2.resultant-ratio", Value(resultant / stated, fixed(2)));
  document.value("far-slope.n-points", Value(std::ssize(ratios) + 1, integer()));
  document.value("far-slope.least", Value(least, fixed(2)));
  document.value("far-slope.most", Value(most, fixed(2)));

  const auto each_agrees = [&](Estimate with) {
    std::vector<Criterion> pairs;
    for (const Estimate ratio : ratios) {
      pairs.push_back(Criterion::agrees_relatively(
          "load", Value(stated * ratio, significant(3), units.line_load),
          Value(with, significant(3), units.line_load),
          Limit(2e-2, LimitKind::choice,
                "the shapes of the two loads may change the ratio by $(a/x)^2/6$, and the mesh of "
                "the run is unknown")));
    }
    return Criterion::in_each("load that follows from the slopes", "pairs of points", pairs);
  };
  document.claim(
      "same-load",
      {.route = "the slope of the printed FEA $z$ over that of the analytical column at "
                "the outermost points, times the stated load, for the same $E$ and $\\nu$",
       .expected = Verdict::fails,
       .criteria = {each_agrees(Estimate{stated, 0})}});
  document.check("slopes-give-the-resultant", {each_agrees(resultant)},
                 "the slopes far from the load give the resultant that the run prints");
}

void describe_error(Document& document, const HalfSpaceCase& c, const UnitSystem& units,
                    const PrintedFigure5& printed) {
  const Estimate fea = as_estimate(printed.fea_z.back());
  const Estimate difference = displacement(c, c.farthest_point()) - fea;
  const double closing = c.datum * std::exp(-difference.value / displacement_scale(c));
  document.value("error.first",
                 Value(as_estimate(printed.error.front()), scientific(2), units.length));
  document.value(
      "error.smallest",
      Value(as_estimate(*std::ranges::min_element(printed.error, {}, &PrintedNumber::value)),
            scientific(2), units.length));
  document.value("error.last",
                 Value(as_estimate(printed.error.back()), scientific(2), units.length));
  document.value("error.last-share", Value(as_estimate(printed.error.back()) / fea, percent(0)));
  document.value("error.datum-that-closes-it",
                 Value(closing, significant(2), units.length).as_is());
  document.value("error.doubling-over-last",
                 Value(std::numbers::ln2 * displacement_scale(c) / difference, percent(0)));
}

}  // namespace

void compute_error_analysis(Document& document, const Case& from) {
  const HalfSpaceCase& c = from.half_space;
  const UnitSystem& units = from.units;
  document.value("datum.doubling",
                 Value(shift_of_doubling(c), scientific(3), units.length).as_is());
  document.value("datum.gradient", Value(gradient(c, c.datum), scientific(3)));
  document.value("datum.gradient-share",
                 Value(gradient(c, c.datum) / gradient(c, c.load.half_width()), scientific(2)));
  if (!from.printed_data) return;
  const PrintedData& printed = *from.printed_data;
  claim_datum(document, c, printed);
  describe_error(document, c, units, printed.figure5);
  compare_resultants(document, c, units, printed);
}

}  // namespace paper
