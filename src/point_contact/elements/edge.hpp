// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace point_contact {

/// A point or a vector of the surface plane z = 0.
using Vector2 = Eigen::Vector2d;

/// a_x b_y − a_y b_x, the signed area of the parallelogram of two vectors.
inline double cross(const Vector2& a, const Vector2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// The contribution of one edge of a polygon, traversed counter-clockwise, to the potentials of a
/// pressure on the polygon at a point P of its plane. h is the distance of P from the edge's line,
/// positive inside, s the coordinate along the line from the foot of the perpendicular, and r² = h²
/// + s²:
struct EdgeIntegrals {
  Vector2 normal;       ///< n, the outward unit normal
  double angular;       ///< h ∫ ds/r, a length; the sum over edges is ∫ dA/r
  double first_moment;  ///< ∫ r ds, an area; the sum over edges of n times it is ∫ (Q−P)/r dA
};

/// The integrals over the edge from `begin` to `end` at the point `at`. They are finite everywhere;
/// on the edge's line, where h = 0, `angular` is 0. If s₁ and s₂ have the same sign, the logarithms
/// in
///
///   ∫ ds/r = asinh(s₂/|h|) − asinh(s₁/|h|),   ∫ r ds = ½[s₂r₂ − s₁r₁ + h² ∫ ds/r]
///
/// are combined into one before evaluation, which avoids cancellation.
EdgeIntegrals edge_integrals(const Vector2& begin, const Vector2& end, const Vector2& at);

}  // namespace point_contact
