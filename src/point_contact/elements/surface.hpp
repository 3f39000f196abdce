// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>

#include "elasticity/material.hpp"
#include "point_contact/elements/lattice.hpp"

namespace point_contact {

/// The displacement (u_x, u_y, u_z) of the surface at a point of it, by a pressure that is linear
/// on a triangle of the surface, whose corners are given counter-clockwise, with these values at
/// them:
///
///   u_xy = −[(1−2ν)(1+ν)/(2πE)] ∫ p (P−Q)/r² dA,   u_z = [(1−ν²)/(πE)] ∫ p dA/r
///
/// (Johnson 3.18 at z = 0). As (P−Q)/r² is −∇ ln r by Q, and p = p(P) + g·(Q−P),
///
///   ∫ p (P−Q)/r² dA = g ∫ ln r dA − Σ n ∫ p ln r ds,   ∫ ln r dA = ½ Σ h ∫ (ln r − ½) ds,
///
/// sums over the edges, all elementary. Finite everywhere, on edges and at corners too. Rounding:
/// 1e-15 times the greatest value and the squared ratio of the distance to the triangle's width.
Eigen::Vector3d surface_displacement(const std::array<Vector2, 3>& corners,
                                     const std::array<double, 3>& values,
                                     const elasticity::Material& material, const Vector2& at);

}  // namespace point_contact
