// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "block/rectangle.hpp"
#include "elasticity/loads.hpp"

namespace block {

/// The index of a node, element or unknown.
using Index = Eigen::Index;

/// A point inside an element: the element's index and ξ, ζ in [−1, 1] along x and z.
struct LocalPoint {
  Index element;
  double xi;
  double zeta;
};

/// One rectangular element, x0 ≤ x ≤ x1 and z0 ≤ z ≤ z1.
struct Element {
  Index column;
  Index row;
  double x0, x1;
  double z0, z1;

  double width() const { return x1 - x0; }
  double height() const { return z1 - z0; }
};

/// A structured mesh of rectangles: every column of elements meets every row.
///
/// The nodes are the Gauss–Lobatto points of each element and also form a grid. Nodes and elements
/// are numbered along x first. z = z_lines.front() is the loaded top.
class Mesh {
 public:
  /// order ≥ 1; x_lines and z_lines rise strictly and have two entries or more.
  Mesh(int order, std::vector<double> x_lines, std::vector<double> z_lines);

  int order() const { return order_; }
  const std::vector<double>& x_lines() const { return x_lines_; }
  const std::vector<double>& z_lines() const { return z_lines_; }

  Index n_columns() const { return static_cast<Index>(x_lines_.size()) - 1; }
  Index n_rows() const { return static_cast<Index>(z_lines_.size()) - 1; }
  Index n_elements() const { return n_columns() * n_rows(); }
  Index n_nodes_along_x() const { return n_columns() * order_ + 1; }
  Index n_nodes_along_z() const { return n_rows() * order_ + 1; }
  Index n_nodes() const { return n_nodes_along_x() * n_nodes_along_z(); }

  Element element(Index index) const;

  /// The node at step i along x and j along z, each 0 … order, of an element.
  Index node(const Element& element, int i, int j) const;

  /// The node's position in the grid of nodes: (step along x, step along z).
  Eigen::Vector2<Index> grid_position(Index node) const;

  /// Whether the node lies inside an element and touches no other.
  bool is_interior(Index node) const;

  /// The element that contains (x, z); on a common edge, the one on the right or below. Throws
  /// InvalidQuantity for a point outside the block.
  LocalPoint locate(double x, double z) const;

 private:
  int order_;
  std::vector<double> x_lines_;
  std::vector<double> z_lines_;
};

/// A point towards which the mesh becomes finer, and the size of the elements beside it.
struct GradedPoint {
  double position;
  double smallest;  ///< length of the element on either side, > 0
};

/// The element boundaries of a line that is graded geometrically towards each of `points`.
///
/// The line between neighbouring points is halved and each half graded towards its point: the
/// element beside it is `smallest` long (or the whole half, if that is shorter), and the distances
/// of successive boundaries grow by at most the factor 1/ratio, 0 < ratio < 1. A point singularity
/// then has the same relative strength in every element, so that high order converges
/// exponentially. `points`, two or more, rise strictly and include the ends of the line.
std::vector<double> graded_lines(const std::vector<GradedPoint>& points, double ratio);

/// The resolution of the finite elements.
struct Discretization {
  int order = 7;   ///< polynomial degree p of the elements, 4 … 10
  int refine = 1;  ///< level of refinement, 1 … 4
};

/// Throws InvalidQuantity for an order or a refinement out of range.
void require_valid(const Discretization& discretization);

/// One order and one level of refinement less, for error estimates; may leave the range above.
Discretization coarser(const Discretization& discretization);

/// Throws InvalidQuantity for a load that extends beyond [left, right], and for concentrated
/// forces, under which the displacement of a continuum is infinite.
void require_inside(const elasticity::Load& load, double left, double right);

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
