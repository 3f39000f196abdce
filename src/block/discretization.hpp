// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "block/mesh.hpp"
#include "block/rectangle.hpp"
#include "elasticity/load.hpp"

namespace block {

/// The resolution of the finite elements.
struct Discretization {
  int order = 7;   ///< polynomial degree p of the elements, 4 … 10
  int refine = 1;  ///< level of refinement, 1 … 4
};

/// Throws InvalidQuantity for an order or a refinement out of range.
void require_valid(const Discretization& discretization);

/// One order and one level of refinement less, for error estimates; may leave the range above.
Discretization coarser(const Discretization& discretization);

/// The ends and kinks of all loads, rising and distinct to 1e-9 of their span. The mesh is graded
/// towards them.
std::vector<double> kinks_of(const std::vector<elasticity::Load>& loads);

/// The mesh of a block for the given loads, or any loads whose kinks are among theirs.
///
/// Columns are graded towards every kink, where stresses have logarithmic kinks or jumps, and rows
/// towards the loaded top. Both are graded towards the sides and the bottom, because in a corner
/// between a clamped and a free side stresses grow like r^−0.29 (ν = 0.3). With refine = N, the
/// element beside a kink is 0.2·0.3^N of the distance to the next kink and that in a corner
/// 0.2·0.3^N of the lesser side of the block; the distances of successive element boundaries from
/// the end grow by the factor 1/(0.2 + 0.07 N). One more level thus adds layers and makes elements
/// smaller everywhere. Throws InvalidQuantity for loads outside the block, concentrated loads, and
/// an empty list.
Mesh graded_mesh(const Rectangle& block, const std::vector<elasticity::Load>& loads,
                 const Discretization& discretization);

/// A disc of the plane x, z.
struct Disc {
  double x;
  double z;
  double radius;

  bool holds(const Eigen::Vector2d& point) const;
};

/// Discs about the points where stresses do not converge as the mesh is refined.
///
/// Beside a jump of the pressure, polynomials overshoot by a tenth of the jump however small the
/// element (Gibbs); the radius is a quarter of the distance to the next kink. In the corners
/// between a clamped and a free side, stresses are unbounded; the radius is a tenth of the lesser
/// side of the block.
std::vector<Disc> discs_without_limit(const Rectangle& block, const Supports& supports,
                                      const elasticity::Load& load);

}  // namespace block
