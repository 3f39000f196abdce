// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "point_contact/elements/lattice.hpp"

namespace point_contact {

/// A count that is never negative, as the standard library and FFTW take it.
inline std::size_t size_of(Eigen::Index n) {
  return static_cast<std::size_t>(n);
}

/// n1 × n2 nodes of a lattice, each with an element of its own, about a centre.
///
/// Staggered rows go back by a node every second row and so fill a rectangle; their lattice.second
/// is half of lattice.first and a vector perpendicular to it. Other rows fill a parallelogram.
///
/// A field on the grid is a vector of n2 rows of n1 values: that of node (i, j) stands at j n1 + i.
struct Grid {
  Lattice lattice;
  Eigen::Index n1;  ///< nodes along lattice.first
  Eigen::Index n2;  ///< nodes along lattice.second
  Vector2 centre = Vector2::Zero();
  bool is_staggered = false;

  Eigen::Index size() const { return n1 * n2; }
  Eigen::Index index(Eigen::Index i, Eigen::Index j) const { return j * n1 + i; }

  /// c = √(area of a cell), a length.
  double spacing() const { return std::sqrt(lattice.cell_area()); }

  /// Not inline, as the next two: programs that are compiled without optimising would bring slow
  /// copies, and the linker takes one for all.
  Vector2 node(Eigen::Index i, Eigen::Index j) const;

  /// How far row j is moved along lattice.first, in nodes: ∓¼ in turn if rows are staggered.
  double shift(Eigen::Index j) const;

  /// The vector from a row to the next, without what shift() is.
  Vector2 between_rows() const;

  /// The i of the node in row j + dj that lies at di·first + dj·second from node (i, j); it may lie
  /// outside the grid. j + dj ≥ −2.
  Eigen::Index neighbour(Eigen::Index i, Eigen::Index j, Eigen::Index di, Eigen::Index dj) const {
    if (!is_staggered) return i + di;
    return i + di + (j + dj + 2) / 2 - (j + 2) / 2;
  }

  /// The same domain with other numbers of nodes.
  Grid with_nodes(Eigen::Index new_n1, Eigen::Index new_n2) const;
};

/// The least number of nodes each way.
inline constexpr Eigen::Index min_nodes = 8;

/// n × n nodes in the middle of as many cells that fill a rectangle of these sides. Throws
/// InvalidQuantity for a side that is not > 0 or n < min_nodes, as the next does.
Grid rectangular_grid(double width, double height, Eigen::Index n);
Grid square_grid(double width, Eigen::Index n);

/// n nodes along x in each of 2n/√3 staggered rows, rounded up: the corners of equilateral
/// triangles that fill a square of this width. If `stretch` is not 1, all is so many times as high.
Grid hexagonal_grid(double width, Eigen::Index n, double stretch = 1);

}  // namespace point_contact
