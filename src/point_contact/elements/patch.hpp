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

/// What the edge of a polygon, gone through counter-clockwise, contributes to the potentials of the
/// pressures on it at a point in its plane. With h the distance of the point from the edge's line,
/// positive inside, s the coordinate along it from the foot of the perpendicular, and r² = h² + s²:
struct EdgeIntegrals {
  Vector2 tangent;      ///< t, the unit vector along the edge
  Vector2 normal;       ///< n, the outward unit normal
  double distance;      ///< h
  double inverse;       ///< ∫ ds/r, a number; infinite on the edge
  double angular;       ///< h ∫ ds/r, a length; the sum over edges is ∫ dA/r
  double first_moment;  ///< ∫ r ds, an area; the sum over edges of n times it is ∫ (Q−P)/r dA
  double rise;          ///< ∫ s/r ds, the rise of r along the edge, a length
  double rise_of_cube;  ///< ∫ s r ds, a third of the rise of r³, a volume
};

/// The integrals over the edge from `begin` to `end` at the point `at`. All but ∫ ds/r are finite
/// everywhere: on the edge's line, where h = 0, `angular` is 0. The logarithms in
///
///   ∫ ds/r = asinh(s₂/|h|) − asinh(s₁/|h|),   ∫ r ds = ½[s₂r₂ − s₁r₁ + h² ∫ ds/r]
///
/// are subtracted before they are taken if s₁ and s₂ have the same sign.
EdgeIntegrals edge_integrals(const Vector2& begin, const Vector2& end, const Vector2& at);

}  // namespace point_contact
