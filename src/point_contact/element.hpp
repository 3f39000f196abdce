// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <string_view>

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

/// The element that represents the pressure around a node of a square lattice. Each carries the
/// load p c², with the spacing c.
enum class Element {
  uniform,  ///< a pressure p over the node's cell: infinite gradient at its edges (Love 1929)
  pyramid   ///< a pyramid on the hexagon of six neighbours: together linear on triangles
            ///< (Johnson §5.9)
};

/// The element's name in messages and on the command line.
std::string_view name_of(Element element);

/// The displacement due to one element, T(d): elements of pressure p_j at the nodes x_j give
///
///   u_z1 + u_z2 at x = (c/(πE*)) Σ_j T((x − x_j)/c) p_j,   T(d) = ∫ B(s)/|d−s| d²s,
///
/// where B is the element of height 1 on the lattice of spacing 1 (Boussinesq; Johnson 3.22). Even.
///
///   uniform  Σ h ∫ds/r over the cell's edges
///   pyramid  linear_potential() of its six triangles; the hexagon has the corners ±(1, 0), ±(0, 1)
///            and ±(1, −1)
///
/// Beyond seven spacings a few weighted points replace them: an element is a point load smeared
/// uniformly along (1, 0), (0, 1) and, for a pyramid, (−1, 1). Accuracy: 1e-14 of T(0), and far
/// away, where T → 1/|d|, 3e-14 relative.
double influence_coefficient(Element element, const Vector2& d);

/// ∫ dA/r over a convex polygon with counter-clockwise corners, at a point of its plane; a length.
/// A uniform pressure p on it displaces the surface by p/(πE*) times this (Love 1929 for
/// rectangles; Johnson 3.25). Finite on edges and at corners. Rounding: 1e-15 times the polygon's
/// size times the ratio of the point's distance to the polygon's width.
double uniform_potential(std::span<const Vector2> corners, const Vector2& at);

/// ∫ σ dA/r over a triangle with counter-clockwise corners, σ linear with the given values at them;
/// a length if the values are dimensionless. With σ(Q) = σ(P) + g·(Q−P),
///
///   ∫ σ/r dA = σ(P) Σ h ∫ds/r + g · Σ n ∫ r ds,  sums over the edges,
///
/// since (Q−P)/r is the gradient of r. Finite everywhere. Rounding as above, with the ratio
/// squared.
double linear_potential(const std::array<Vector2, 3>& corners, const std::array<double, 3>& values,
                        const Vector2& at);

}  // namespace point_contact
