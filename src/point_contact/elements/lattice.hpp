// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "system/require.hpp"

namespace point_contact {

/// A point or a vector of the surface plane z = 0.
using Vector2 = Eigen::Vector2d;

/// a_x b_y − a_y b_x, the signed area of the parallelogram of two vectors.
inline double cross(const Vector2& a, const Vector2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// The vectors between neighbouring nodes: node (i, j) lies at i·first + j·second from node (0, 0).
/// Two vectors of equal length at 90° make a square lattice, at 60° one of equilateral triangles.
struct Lattice {
  Vector2 first;
  Vector2 second;

  /// |first × second|, the area that each node stands for.
  double cell_area() const { return std::abs(cross(first, second)); }

  /// The same lattice with cells of area 1.
  Lattice normalised() const {
    const double scale = 1 / std::sqrt(cell_area());
    return {scale * first, scale * second};
  }

  /// Whether the two vectors are perpendicular, so that cells are rectangles: to rounding.
  bool is_rectangular() const {
    constexpr double rounding = 1e-14;
    return std::abs(first.dot(second)) <= rounding * first.norm() * second.norm();
  }
};

/// Square cells, and rhombi of two equilateral triangles each, of the given spacing > 0 or
/// InvalidQuantity is thrown.
inline Lattice square_lattice(double spacing) {
  sys::require_positive("spacing", spacing);
  return {{spacing, 0}, {0, spacing}};
}
inline Lattice hexagonal_lattice(double spacing) {
  sys::require_positive("spacing", spacing);
  return {{spacing, 0}, {spacing / 2, std::sqrt(3.0) / 2 * spacing}};
}

}  // namespace point_contact
