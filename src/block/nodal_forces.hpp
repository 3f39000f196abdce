// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>

#include "block/lobatto_basis.hpp"
#include "block/mesh.hpp"
#include "elasticity/load.hpp"

namespace block {

/// A vector field in the plane: (x, z) ↦ (x component, z component).
using Field = std::function<Eigen::Vector2d(double x, double z)>;

/// The consistent nodal forces ∫ N_i(x) (q, p) dx of a load on the top of the block.
///
/// Size 2·n_nodes, unknown 2·node + c, force per unit thickness; p acts along +z, q along +x. The
/// quadrature is split at the load's kinks and the elements' corners and graded to both ends of
/// each part by x ∝ 3t² − 2t³: exact to rounding for polynomial tractions up to degree 4, and 1e-12
/// relative where a traction rises like a square root at an end of a piece. Throws InvalidQuantity
/// for a load that reaches outside the block, and for concentrated forces, under which the
/// displacement of a continuum is infinite.
Eigen::VectorXd surface_forces(const Mesh& mesh, const LobattoBasis& basis,
                               const elasticity::Load& load);

/// The consistent nodal forces ∫ N_i b dx dz of a body force b, force per volume.
Eigen::VectorXd body_forces(const Mesh& mesh, const LobattoBasis& basis, const Field& body_force);

/// Throws InvalidQuantity as surface_forces does, without computing anything.
void require_inside(const elasticity::Load& load, double left, double right);

}  // namespace block
