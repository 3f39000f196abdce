// SPDX-License-Identifier: GPL-3.0-or-later
// The two spheres of the case, pressed together with pyramids, against Hertz.
#pragma once

#include "paper/prelude.hpp"
#include "point_contact/study/two_spheres.hpp"

namespace paper {

/// Pyramids along each side of the square that contains the spheres' contact, 46 of them over its
/// radius.
inline constexpr Eigen::Index nodes_of_contact = 96;

/// Spheres with the radii and the materials of the case's cylinders.
point_contact::TwoSpheres two_spheres(const ContactCase& c, const PointContactCase& p);

/// The magnitudes of the relative errors against Hertz, each with how wrong it may be.
struct SphereErrors {
  Estimate peak, radius, approach;
  double square;  ///< (c/a)², c² the area that belongs to a node
};
SphereErrors sphere_errors(const ContactCase& c, const PointContactCase& p);

}  // namespace paper
