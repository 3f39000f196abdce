// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "point_contact/elements/lattice.hpp"

namespace point_contact {

/// A pressure on a triangle or a parallelogram of the surface. Along each edge it is linear, and
///
///   p(Q) = p(P) + g·(Q−P) + ½(Q−P)ᵀH(Q−P),  tr H = 0,
///
/// with H = 0 but for the bilinear pressure on a rectangle. Corners are given counter-clockwise.
class Patch {
 public:
  /// Linear, with these values at the corners.
  static Patch triangle(const std::array<Vector2, 3>& corners, const std::array<double, 3>& values);

  /// The same value all over a parallelogram.
  static Patch uniform(const std::array<Vector2, 4>& corners, double value);

  /// Bilinear on a rectangle, with these values at the corners.
  static Patch bilinear(const std::array<Vector2, 4>& corners, const std::array<double, 4>& values);

  std::span<const Vector2> corners() const { return {corners_.data(), n_corners_}; }

  /// The terms of p about the point P, which may lie outside.
  struct Expansion {
    double value;             ///< p(P)
    Vector2 gradient;         ///< g
    Eigen::Matrix2d hessian;  ///< H
  };
  Expansion about(const Vector2& at) const;

 private:
  Patch(std::span<const Vector2> corners, double value);

  std::array<Vector2, 4> corners_;
  std::size_t n_corners_;
  Expansion at_first_corner_;
};

}  // namespace point_contact
