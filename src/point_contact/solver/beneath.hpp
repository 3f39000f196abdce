// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "point_contact/elements/interior.hpp"
#include "point_contact/solver/solution.hpp"

namespace point_contact {

/// The displacements and stresses in the body beneath, of this material, at a depth z > 0 or
/// InvalidQuantity is thrown: the sum of interior_field() over what the elements' pressure is made
/// of, triangles between the nodes (pyramids), rectangles between them (bilinear) or the nodes'
/// cells (uniform), or of field_of_force() over the nodes (point). Cost: 1 µs for each triangle in
/// contact. Accuracy: the pressure's own; rounding grows with the square of the distance in
/// spacings, to 1e-10 of the field at a thousand.
InteriorField field_beneath(const Solution& solution, const elasticity::Material& material,
                            const Eigen::Vector3d& at);

/// The displacement (u_x, u_y, u_z) of the surface of the body of this material, by the same
/// pressure: the sum of surface_displacement(). InvalidQuantity is thrown at the nodes of forces,
/// where it is infinite.
Eigen::Vector3d displacement_of_surface(const Solution& solution,
                                        const elasticity::Material& material, const Vector2& at);

/// ∇(u_z1 + u_z2) at a point of the surface, by the same pressure: the sum of surface_gradient().
/// Throws InvalidQuantity where an element's own gradient is not finite: at the nodes of forces, on
/// the edges between cells, and, though the sum would be finite there, on the edges of the
/// triangles and rectangles of the others.
Vector2 slope_of_surface(const Solution& solution, double contact_modulus, const Vector2& at);

}  // namespace point_contact
