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

}  // namespace point_contact
