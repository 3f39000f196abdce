// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/spheres.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "paper/bounds.hpp"
#include "paper/conventions.hpp"
#include "paper/prelude.hpp"
#include "point_contact/bodies/profile.hpp"
#include "point_contact/closed_forms/hertz_elliptic.hpp"
#include "point_contact/solver/methods.hpp"
#include "point_contact/study/two_spheres.hpp"

namespace paper {

using Eigen::Index;
using point_contact::Vector2;

using PointSolution = point_contact::Solution;

void cross_cylinders(Document& document, const ContactCase& c, double load, Index n_nodes) {
  constexpr double longest = 1e3;  // the greater curvature over the smaller
  const double first = c.body1.radius.curvature();
  const double second = c.body2.radius.curvature();
  const bool is_possible =
      std::min(first, second) > 0 && std::max(first, second) < longest * std::min(first, second);
  document.flag("spheres.crossed", is_possible);
  if (!is_possible) return;
  const auto curvatures =
      point_contact::relative_curvatures({first, 0}, {second, 0}, std::numbers::pi / 2);
  const double modulus = c.cylinders.contact_modulus();
  const point_contact::HertzElliptic hertz(modulus, curvatures.x, curvatures.y, load);
  const double a = hertz.semi_axis_x();
  const double b = hertz.semi_axis_y();
  constexpr double share = 0.9;
  const PointSolution solution = point_contact::solve_for_load(
      {point_contact::Profile::elliptic_paraboloid(curvatures.x, curvatures.y), modulus,
       point_contact::hexagonal_grid(2 * a / share, n_nodes, b / a)},
      load, {.tolerance = 1e-9});

  const double bound = pressure_bound(solution) + rounded(1);
  const Vector2 axes = solution.semi_axes();
  const Estimate closed{a / b, rounded(1e2 * a / b)};
  const double of_axis = bound_of_radius(bound);
  const Estimate long_error{std::abs(axes[0] / a - 1), of_axis};
  const Estimate short_error{std::abs(axes[1] / b - 1), of_axis};
  document.value("crossed.axes", Value(closed, fixed(3)));
  document.value("crossed.long-error", Value(long_error, scientific(2).rounded_up()));
  document.value("crossed.short-error", Value(short_error, scientific(2).rounded_up()));
  document.value("crossed.peak-error",
                 Value({std::abs(solution.peak_pressure() / hertz.peak_pressure() - 1), bound},
                       scientific(2).rounded_up()));
  // In units of the elements along each axis: c = √(area), and the cells are stretched like it.
  const double square = solution.grid.lattice.cell_area() / (a * b);
  const auto small = [&](const char* what, Estimate error, const Limit& limit) {
    return Criterion::at_most(what, Value(error, scientific(2).rounded_up()), limit);
  };
  document.check("crossed-cylinders",
                 {small("relative error of the peak",
                        {std::abs(solution.peak_pressure() / hertz.peak_pressure() - 1), bound},
                        of_second_order(square)),
                  small("of the long semi-axis", long_error, of_second_order(square)),
                  small("of the short semi-axis", short_error, of_second_order(square))},
                 "crossed cylinders have the peak pressure and the semi-axes of Hertz's ellipse");
}

}  // namespace paper
