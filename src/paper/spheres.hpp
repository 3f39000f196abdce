// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "paper/conventions.hpp"
#include "point_contact/hertz.hpp"
#include "point_contact/solution.hpp"

namespace paper {

/// Spheres with the radii and materials of the case's cylinders, by Hertz and by pyramids on a
/// square lattice with no node at the centre.
struct Spheres {
  point_contact::Hertz hertz;
  point_contact::Solution solution;
};
Spheres solve_spheres(const ContactCase& c, const PointContactCase& p);

/// The magnitudes of the relative errors against Hertz.
struct SphereErrors {
  double peak, radius, approach;
  double square;  ///< (c/a)²
};
SphereErrors errors_of(const Spheres& spheres);

}  // namespace paper
