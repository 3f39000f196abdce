// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "block/mesh.hpp"
#include "block/rectangle.hpp"
#include "elasticity/load.hpp"

namespace block {

/// How finely the block is divided.
struct Discretization {
  int order = 7;   ///< polynomial degree p of the elements, 4 … 10
  int refine = 1;  ///< level of refinement, 1 … 4
};

/// Throws InvalidQuantity for an order or a refinement out of range.
void require_valid(const Discretization& discretization);

/// One order and one level of refinement less, which may leave the range above: what an error is
/// estimated with.
Discretization coarser(const Discretization& discretization);

/// The ends and kinks of all loads, rising, each once (to 1e-9 of their span): what the mesh is
/// graded to.
std::vector<double> kinks_of(const std::vector<elasticity::Load>& loads);

/// The mesh of a block that is to carry the given loads, or any whose kinks are among theirs.
///
/// Columns are graded towards every kink, where stresses have logarithmic kinks or jumps, rows
/// towards the loaded top, and both towards the sides and the bottom, in whose corners a clamped
/// and a free side meet with stresses like r^−0.29 (ν = 0.3). With refine = N the element beside a
/// kink is 0.2·0.3^N of the distance to the next kink, that in a corner 0.2·0.3^N of the lesser
/// side of the block, and the distance of the element boundaries from the end grows by 1/(0.2 +
/// 0.07 N) from each to the next: a level more means more layers, and smaller elements everywhere.
/// Throws InvalidQuantity for loads outside the block or concentrated, and for no load at all.
Mesh graded_mesh(const Rectangle& block, const std::vector<elasticity::Load>& loads,
                 const Discretization& discretization);

/// A disc of the plane x, z.
struct Disc {
  double x;
  double z;
  double radius;

  bool holds(const Eigen::Vector2d& point) const;
};

/// The discs about the points of the block where stresses have no limit as the mesh is refined.
///
/// They are the places where the pressure jumps, beside which polynomials overshoot by a tenth of
/// the jump however small the element (Gibbs), and the corners between a clamped and a free side,
/// where stresses grow without bound. A radius is a quarter of the distance to the next kink of
/// the load, or a tenth of the lesser side of the block.
std::vector<Disc> discs_without_limit(const Rectangle& block, const Supports& supports,
                                      const elasticity::Load& load);

}  // namespace block
