// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/spheres.hpp"

#include <cmath>

#include "paper/bounds.hpp"
#include "paper/prelude.hpp"

namespace paper {

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

}  // namespace paper
