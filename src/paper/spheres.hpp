// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "paper/prelude.hpp"
#include "point_contact/bodies/profile.hpp"
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

/// Registers what pyramids, hats, uniform elements and forces are worth between two spheres:
/// orders and factors of their errors against Hertz and Huber, and the claims on them.
void study_elements(Document& document, const ContactCase& c,
                    const point_contact::TwoSpheres& spheres);

/// Registers what the section on spheres says of these spheres when one of them is rough: its
/// greatest pressure and the area in contact.
void press_rough_sphere(Document& document, const point_contact::TwoSpheres& spheres,
                        const point_contact::Roughness& roughness);

/// Registers what the section on spheres says of the case's cylinders, crossed at right angles
/// under a load and solved on n_nodes along a side; nothing but the flag that says so if one is a
/// plane or a hollow, or if the ellipse is so long that square cells would be needles.
void cross_cylinders(Document& document, const ContactCase& c, double load, long n_nodes);

/// Adds the pyramid and a neighbour over the lattice to a figure, in units of the spacing, a line a
/// row of two points.
void draw_pyramid(Figure& figure);

}  // namespace paper
