// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "point_contact/elements/interior.hpp"
#include "point_contact/solver/solution.hpp"

namespace point_contact {

/// The displacements and stresses in the body beneath, of this material, at a depth z > 0: the sum
/// of interior_field() over the triangles between the nodes. For bodies whose pressure is made of
/// pyramids, or InvalidQuantity is thrown, as for z ≤ 0. Cost: 1 µs for each triangle in contact.
/// Accuracy: the pressure's own; rounding grows with the square of the distance in spacings, to
/// 1e-10 of the field at a thousand.
InteriorField field_beneath(const Solution& solution, const elasticity::Material& material,
                            const Eigen::Vector3d& at);

/// The displacement (u_x, u_y, u_z) of the surface of the body of this material, by the same
/// pressure: the sum of surface_displacement() over the same triangles, for pyramids alone.
Eigen::Vector3d displacement_of_surface(const Solution& solution,
                                        const elasticity::Material& material, const Vector2& at);

}  // namespace point_contact
