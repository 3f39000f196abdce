// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "elasticity/surface_quadrature.hpp"
#include "paper/bounds.hpp"
#include "paper/conventions.hpp"
#include "paper/paper.hpp"
#include "paper/printed_data.hpp"

namespace paper {
namespace {

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
    const Estimate off = abs(by_quadrature - exact);
    shares.push_back(Criterion::at_most(
        "share", Value(off.abs_error == 0 ? 0 : off.value / off.abs_error, significant(1)).as_is(),
        {LimitKind::data, 1.0, "the error that the quadrature reports, and rounding"}));
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

}  // namespace

void compute_tangential(Document& document, const Case& from) {
  const HalfSpaceCase& c = from.half_space;
  measure_tangential(document, c, from.units);
  if (from.printed_data) compare_tangential(document, c, from.units, *from.printed_data);
}

}  // namespace paper
