// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "elasticity/material.hpp"
#include "point_contact/elements/patch.hpp"

namespace point_contact {

/// The displacement (u_x, u_y, u_z) of the surface at a point P of it, by a pressure on a patch:
///
///   u_xy = −[(1−2ν)(1+ν)/(2πE)] ∫ p (P−Q)/r² dA,   u_z = [(1−ν²)/(πE)] ∫ p dA/r
///
/// (Johnson 3.18 at z = 0). As (P−Q)/r² is −∇ ln r by Q, and ∇p = g + H (Q−P),
///
///   ∫ p (P−Q)/r² dA = g ∫ ln r dA + H Σ n ∫ w ds − Σ n ∫ p ln r ds,
///   ∫ ln r dA = ½ Σ h ∫ (ln r − ½) ds,   w = ½ r² (ln r − ½),
///   ∫ p dA/r = p(P) Σ h ∫ ds/r + Σ n·(g ∫ r ds + ½ H ∫ r (Q−P) ds),
///
/// sums over the edges, all elementary. Finite everywhere, on edges and at corners too. Rounding:
/// 1e-15 times the greatest value and the squared ratio of the distance to the patch's width.
Eigen::Vector3d surface_displacement(const Patch& patch, const elasticity::Material& material,
                                     const Vector2& at);

/// ∇ ∫ p dA/r at a point of the surface, a stress: times 1/(πE*) the slope of the surfaces of both
/// bodies together,
///
///   ∫ ∇p dA/r − Σ n ∫ p/r ds,
///
/// sums over the edges. Not finite on an edge, even on one between two patches where the infinite
/// parts would cancel. Rounding as above.
Vector2 surface_gradient(const Patch& patch, const Vector2& at);

}  // namespace point_contact
