// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

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

}  // namespace block
