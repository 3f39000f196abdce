// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "elasticity/material.hpp"
#include "point_contact/elements/patch.hpp"

namespace point_contact {

/// What a pressure on the surface does at a point of the body.
struct InteriorField {
  Eigen::Vector3d displacement = Eigen::Vector3d::Zero();  ///< (u_x, u_y, u_z), lengths
  Eigen::Matrix3d stress = Eigen::Matrix3d::Zero();  ///< σ, tension positive; σ_zz → −p at z = 0

  InteriorField& operator+=(const InteriorField& other);
};

/// The displacements and stresses at `at`, z > 0 into the body, by a pressure on a patch of the
/// surface.
///
/// Love's potentials of the pressure, φ = ∫ p dA/ρ and ψ = ∫ p ln(ρ+z) dA (Johnson 3.7–3.13):
///
///   u_x = −[(1−2ν) ψ_x + z φ_x]/(4πG),  u_z = [2(1−ν) φ − z φ_z]/(4πG),
///   σ_xx = [2ν φ_z − z φ_xx − (1−2ν) ψ_xx]/(2π),  σ_zz = [φ_z − z φ_zz]/(2π),
///   σ_xy = −[z φ_xy + (1−2ν) ψ_xy]/(2π),  σ_xz = −z φ_xz/(2π),
///
/// whose derivatives become, by the divergence theorem, integrals of p/ρ, p/ρ³, p ln(ρ+z) and
/// p/[ρ(ρ+z)] along the edges, all elementary. Throws InvalidQuantity for z ≤ 0: on the surface
/// itself the stresses of a single patch are infinite at its edges. Accuracy: 1e-14 of the
/// greatest value near the patch; of the field's own magnitude, less by the square of the distance
/// in units of the patch's height.
InteriorField interior_field(const Patch& patch, const elasticity::Material& material,
                             const Eigen::Vector3d& at);

/// The displacements and stresses in a body at d = (x, y, z), z > 0, from a force P into its
/// surface at the origin: Boussinesq (Johnson 3.18, 3.19), with ρ = |d| and G the shear modulus
///
///   u_xy = [P/(4πG)] [z/ρ³ − (1−2ν)/(ρ(ρ+z))] (x, y),  u_z = [P/(4πG)] [z²/ρ³ + 2(1−ν)/ρ],
///   σ_xx = (P/2π) {(1−2ν) [z/ρ³ − 1/(ρ(ρ+z)) + x²(2ρ+z)/(ρ³(ρ+z)²)] − 3x²z/ρ⁵},
///   σ_xy = (P/2π) xy {(1−2ν)(2ρ+z)/(ρ³(ρ+z)²) − 3z/ρ⁵},
///   σ_xz = −(3P/2π) xz²/ρ⁵,  σ_zz = −(3P/2π) z³/ρ⁵.
///
/// Throws InvalidQuantity for z ≤ 0. Accuracy: some roundings of the greatest component.
InteriorField field_of_force(double force, const elasticity::Material& material,
                             const Eigen::Vector3d& at);

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
