// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "paper/bounds.hpp"
#include "paper/paper.hpp"
#include "paper/spheres.hpp"
#include "point_contact/study/two_spheres.hpp"

namespace paper {
namespace {

using Eigen::Index;
using point_contact::TwoSpheres;
using point_contact::Vector2;

using PointElement = point_contact::Element;
using PointSolution = point_contact::Solution;
using SphereHertz = point_contact::Hertz;

double least_radius(const ContactCase& c) {
  return 1 / std::max(std::abs(c.body1.radius.curvature()), std::abs(c.body2.radius.curvature()));
}

Figure sphere_figure(const PointSolution& solution, const SphereHertz& hertz) {
  constexpr double shown = 1.2;  // over a
  const double a = hertz.radius();
  const double p0 = hertz.peak_pressure();
  std::vector<double> x, pressure, row_x, row_pressure, r, difference;
  constexpr int n = 200;
  x.push_back(-shown);
  pressure.push_back(0);
  for (int i = -n; i <= n; ++i) {
    x.push_back(std::sin(std::numbers::pi / 2 * i / n));
    pressure.push_back(hertz.pressure(x.back() * a) / p0);
  }
  x.push_back(shown);
  pressure.push_back(0);
  const point_contact::Grid& grid = solution.grid;
  for (Index j = 0; j < grid.n2; ++j) {
    for (Index i = 0; i < grid.n1; ++i) {
      const Vector2 at = grid.node(i, j);
      const double p = solution.pressure[grid.index(i, j)] / p0;
      const double error = std::abs(p - hertz.pressure(at.norm()) / p0);
      if (at.norm() < shown * a && error > 0) {
        r.push_back(at.norm() / a);
        difference.push_back(error);
      }
      if (j != grid.n2 / 2 || std::abs(at.x()) > shown * a) continue;
      row_x.push_back(at.x() / a);
      row_pressure.push_back(p);
    }
  }
  return {.width_cm = 15.4,
          .height_cm = 4.4,
          .data = {{"hertz", {{"x", x}, {"pressure", pressure}}},
                   {"row", {{"x", row_x}, {"pressure", row_pressure}}},
                   {"nodes", {{"r", r}, {"difference", difference}}}},
          .numbers = {{"shown", shown}}};
}

void check_spheres(Document& document, const TwoSpheres& spheres, const PointSolution& solution) {
  const SphereHertz hertz = spheres.hertz();
  const contact::Residuals& r = solution.residuals;
  // Displacements are sums of as many rounded terms as there are nodes along a side, in the mean.
  const double rounding = rounded(static_cast<double>(solution.grid.n1));
  document.value("spheres.residual",
                 Value(r.gap / hertz.approach() + rounding, scientific(1).rounded_up()).as_is());
  document.check(
      "pyramids-solve-point-contacts",
      {Criterion::at_most("largest residual of eq. (1a) in contact, over the approach",
                          Value({r.gap / hertz.approach(), rounding}, scientific(1)),
                          {LimitKind::choice, 1e-7, "what no drawing shows"}),
       Criterion::at_most("deepest penetration outside, over the approach",
                          Value({r.separation / hertz.approach(), rounding}, scientific(1)),
                          {LimitKind::choice, 1e-7, "the same"}),
       Criterion::at_most("residual of equilibrium, over the load",
                          Value(r.load / spheres.load, scientific(1)).as_is(),
                          {LimitKind::choice, 1e-11, "a sum of thousands of terms"})},
      "an array of pyramids solves the contact of two spheres");
}

void compare_with_hertz(Document& document, const ContactCase& c, const PointContactCase& p,
                        const UnitSystem& units, const TwoSpheres& spheres) {
  const SphereHertz hertz = spheres.hertz();
  const PointSolution solution = solve_spheres(spheres, PointElement::pyramid, nodes_of_contact);
  const double a = hertz.radius();
  const auto closed = [&](const char* key, double number, const std::string& unit) {
    document.value(key, Value(number, significant(4), unit).within(rounded(c, number)));
  };
  document.value("spheres.load", Value(spheres.load, exact(), units.force));
  closed("spheres.radius", a, units.length);
  closed("spheres.peak", hertz.peak_pressure(), units.stress);
  document.value("spheres.of-radius",
                 Value(a / least_radius(c), percent(1)).within(rounded(c, a / least_radius(c))));
  document.value("spheres.nodes", Value(nodes_of_contact, integer()));
  document.value("spheres.rows", Value(solution.grid.n2, integer()));
  document.value("spheres.in-contact", Value(solution.n_in_contact(), integer()));
  document.value("spheres.elements", Value(closed_form(a / solution.grid.spacing()), fixed(1)));
  document.value("spheres.products", Value(solution.work.products, integer()));
  const SphereErrors errors = sphere_errors(c, p);
  document.value("spheres.peak-error", Value(errors.peak, scientific(2)));
  document.value("spheres.radius-error", Value(errors.radius, scientific(2)));
  Figure figure = sphere_figure(solution, hertz);
  draw_pyramid(figure);
  document.figure("sphere-pressure", std::move(figure));
  check_spheres(document, spheres, solution);
}

}  // namespace

point_contact::TwoSpheres two_spheres(const ContactCase& c, const PointContactCase& p) {
  return {.contact_modulus = c.cylinders.contact_modulus(),
          .relative_curvature = c.cylinders.relative_curvature(),
          .load = p.load};
}

SphereErrors sphere_errors(const ContactCase& c, const PointContactCase& p) {
  const point_contact::TwoSpheres spheres = two_spheres(c, p);
  const point_contact::Solution solution =
      solve_spheres(spheres, point_contact::Element::pyramid, nodes_of_contact);
  const point_contact::PressureErrors errors = pressure_errors(spheres, solution);
  const double bound = pressure_bound(solution);
  const double closed = rounded(c, 1);
  return {.peak = {std::abs(errors.peak), bound + closed},
          .radius = {std::abs(errors.radius), bound_of_radius(bound) + closed},
          .approach = {std::abs(errors.approach), bound_of_approach(bound) + closed},
          .square = 1 / (errors.elements * errors.elements)};
}

void compute_spheres(Document& document, const Case& from) {
  if (!from.point_contact) return;
  const ContactCase& c = from.contact;
  const PointContactCase& p = *from.point_contact;
  const TwoSpheres spheres = two_spheres(c, p);
  compare_with_hertz(document, c, p, from.units, spheres);
  study_elements(document, c, spheres);
  cross_cylinders(document, c, spheres.load, nodes_of_contact);
  press_rough_sphere(document, spheres, p.roughness);
}

}  // namespace paper
