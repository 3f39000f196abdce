// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "elasticity/material.hpp"
#include "point_contact/elements/interior.hpp"

namespace point_contact {

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

}  // namespace point_contact
