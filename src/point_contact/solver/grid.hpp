// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "point_contact/elements/lattice.hpp"

namespace point_contact {

/// n1 × n2 nodes of a lattice, each with an element of its own, about a centre.
///
/// A field on the grid is a vector of n2 rows of n1 values: that of node (i, j) stands at j n1 + i.
struct Grid {
  Lattice lattice;
  Eigen::Index n1;  ///< nodes along lattice.first
  Eigen::Index n2;  ///< nodes along lattice.second
  Vector2 centre = Vector2::Zero();

  Eigen::Index size() const { return n1 * n2; }
  Eigen::Index index(Eigen::Index i, Eigen::Index j) const { return j * n1 + i; }

  /// c = √(area of a cell), a length.
  double spacing() const { return std::sqrt(lattice.cell_area()); }

  Vector2 node(Eigen::Index i, Eigen::Index j) const {
    return centre + (static_cast<double>(i) - static_cast<double>(n1 - 1) / 2) * lattice.first +
           (static_cast<double>(j) - static_cast<double>(n2 - 1) / 2) * lattice.second;
  }
};

/// The least number of nodes each way.
inline constexpr Eigen::Index min_nodes = 8;

/// n × n nodes in the middle of as many cells that fill a rectangle of these sides. Throws
/// InvalidQuantity for a side that is not > 0 or n < min_nodes, as the next does.
Grid rectangular_grid(double width, double height, Eigen::Index n);
Grid square_grid(double width, Eigen::Index n);

/// n × n nodes that fill a rhombus of equilateral triangles: two sides along x, of the length
/// `side`, at 60° to the others, so that the greatest circle in it has the radius √3/4 side. If
/// `stretch` is not 1, all is so many times as high.
Grid hexagonal_grid(double side, Eigen::Index n, double stretch = 1);

/// Throws InvalidQuantity if a contact on n1 × n2 nodes needs more memory than this machine has;
/// the message says how much.
void require_memory(Eigen::Index n1, Eigen::Index n2);

}  // namespace point_contact
