// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "elasticity/surface_quadrature.hpp"
#include "paper/conventions.hpp"
#include "paper/paper.hpp"

namespace paper {
namespace {

// Compares u_x in the finite-element columns, √(magnitude² − z²), with u_z and with the half-space.
void compare_tangential(Document& document, const HalfSpaceCase& c, const UnitSystem& units,
                        const PrintedData& printed, double outside) {
  const PrintedFigure5& columns = printed.figure5;
  Estimate largest_share, largest_excess;
  for (std::size_t i = 0; i < c.points.size(); ++i) {
    const Estimate u_z = as_estimate(columns.fea_z[i]);
    largest_share =
        max(largest_share, other_component(columns.fea_magnitude[i], columns.fea_z[i]) / u_z);
    largest_excess = max(largest_excess, as_estimate(columns.fea_magnitude[i]) / u_z - 1);
  }
  document.value("tangential.largest-excess", Value(largest_excess, percent(1)));
  document.value("tangential.largest-share", Value(largest_share, percent(0)));
  document.value("tangential.last-share",
                 Value(outside / displacement(c, c.farthest_point()), percent(1)));
  document.value("tangential.at-zero",
                 Value(other_component(columns.fea_magnitude.front(), columns.fea_z.front()),
                       scientific(2), units.length));
  const Estimate in_summary = as_estimate(measure(printed, "max_disp_x"));
  document.value("tangential.max-disp-x", Value(in_summary, scientific(4), units.length));
  document.value("tangential.max-disp-x-ratio", Value(in_summary / outside, fixed(2)));
  document.claim(
      "tangential-negligible",
      {.route = "the $x$-displacement recovered from the printed magnitude and $z$",
       .expected = Verdict::fails,
       .criteria = {Criterion::at_most("largest $x$-displacement over $z$",
                                       Value(largest_share, percent(0)), nearly_identical())}});
}

}  // namespace

void compute_tangential(Document& document, const Case& from) {
  const HalfSpaceCase& c = from.half_space;
  // u_x is constant outside the load.
  const double end = std::max(c.farthest_point(), c.load.half_width());
  const double outside = std::abs(tangential_displacement(c.material, c.load, end));
  document.value("tangential.outside", Value(outside, scientific(3), from.units.length).as_is());
  document.value("tangential.share", Value(outside / displacement(c, 0), percent(0)));
  if (from.printed_data) {
    compare_tangential(document, c, from.units, *from.printed_data, outside);
  }
}

}  // namespace paper
