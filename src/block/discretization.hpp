// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "block/mesh.hpp"
#include "block/rectangle.hpp"
#include "elasticity/load.hpp"

namespace block {

/// How finely the block is divided.
struct Discretization {
  int order = 7;                ///< polynomial degree p of the elements, 2 … 10
  int refine = 1;               ///< level of refinement, 0 … 6
  double max_megabytes = 2000;  ///< a mesh estimated to need more is refused
};

/// Throws InvalidQuantity for an order or a refinement out of range.
void require_valid(const Discretization& discretization);

/// The discretisation an error is estimated with: one order and, above 0, one level of refinement
/// less.
Discretization coarser(const Discretization& discretization);

/// The ends and kinks of the tractions of all loads, rising, each once (to 1e-9 of their span):
/// what the mesh is graded to.
std::vector<double> kinks_of(const std::vector<elasticity::Load>& loads);

/// The mesh of a block that is to carry the given loads, or any whose kinks are among theirs.
///
/// Columns are graded towards every kink, where stresses have logarithmic kinks or jumps, rows
/// towards the loaded top, and both towards the sides and the bottom, in whose corners a clamped
/// and a free side meet with stresses like r^−0.29 (ν = 0.3). With refine = N the element beside a
/// kink is 0.2·0.3^N of the distance to the next kink, that in a corner 0.2·0.3^N of the block, and
/// the distance of the element boundaries from the end grows by 1/(0.2 + 0.07 N) from each to the
/// next: a level more means more layers, and smaller elements everywhere. Throws InvalidQuantity
/// for loads outside the block or concentrated, for no load at all, and as require_valid.
Mesh graded_mesh(const Rectangle& block, const std::vector<elasticity::Load>& loads,
                 const Discretization& discretization);

}  // namespace block
