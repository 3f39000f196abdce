// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "block/lobatto_basis.hpp"
#include "block/mesh.hpp"
#include "elasticity/load.hpp"

namespace block {

/// The consistent nodal forces ∫ N_i(x) p dx of a load on the top of the block.
///
/// Size 2·n_nodes, unknown 2·node + c for the component c (0: x, 1: z), force per unit thickness.
/// The quadrature is split at the load's kinks and the elements' corners and graded towards both
/// ends of each part by x ∝ 3t² − 2t³. Accuracy: rounding for polynomial pressures up to degree 4,
/// 1e-12 relative for a pressure that rises like a square root at an end of a piece. Throws what
/// require_inside throws.
Eigen::VectorXd surface_forces(const Mesh& mesh, const LobattoBasis& basis,
                               const elasticity::Load& load);

/// Throws InvalidQuantity for a load that extends beyond [left, right], and for concentrated
/// forces, under which the displacement of a continuum is infinite.
void require_inside(const elasticity::Load& load, double left, double right);

}  // namespace block
