// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "point_contact/elements/edge.hpp"

namespace point_contact {

/// Converts a non-negative count to the type of the standard library and FFTW.
inline std::size_t size_of(Eigen::Index n) {
  return static_cast<std::size_t>(n);
}

/// n1 × n2 nodes of a square lattice about the origin, each with an element.
///
/// A field on the grid is a vector of n2 rows of n1 values; node (i, j) is at index j n1 + i.
struct Grid {
  double spacing;   ///< c, a length
  Eigen::Index n1;  ///< nodes along x
  Eigen::Index n2;  ///< nodes along y

  Eigen::Index size() const { return n1 * n2; }
  Eigen::Index index(Eigen::Index i, Eigen::Index j) const { return j * n1 + i; }
  double cell_area() const { return spacing * spacing; }
  Vector2 node(Eigen::Index i, Eigen::Index j) const {
    return {(static_cast<double>(i) - static_cast<double>(n1 - 1) / 2) * spacing,
            (static_cast<double>(j) - static_cast<double>(n2 - 1) / 2) * spacing};
  }
};

/// The fewest and the most nodes along a side; the most take 7 GB.
inline constexpr Eigen::Index min_nodes = 8;
inline constexpr Eigen::Index max_nodes = 8192;

/// A grid of square cells with a node in the middle of each: n along the longer side of a
/// rectangle, and as many as fill the shorter side. Throws InvalidQuantity for a side that is not >
/// 0 and for n outside [min_nodes, max_nodes].
Grid rectangular_grid(double width, double height, Eigen::Index n);

/// n × n nodes that fill a square. Throws what rectangular_grid throws.
Grid square_grid(double width, Eigen::Index n);

}  // namespace point_contact
