// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "point_contact/elements/lattice.hpp"
#include "point_contact/elements/multipole.hpp"

namespace point_contact {

/// What stands at a node for the pressure around it. All carry the load p times the cell's area.
enum class Element {
  point,     ///< a concentrated force: infinite displacement under it
  uniform,   ///< a pressure p over the node's cell: infinite gradient at its edges (Love 1929)
  bilinear,  ///< a hat on four cells, linear along each of two perpendicular directions
  pyramid    ///< a pyramid on the hexagon of the six neighbours: together linear on triangles
             ///< (Johnson §5.9)
};

/// The element's name in messages.
std::string_view name_of(Element element);

/// The displacement by one element on a lattice, T(d): with cells of area A and c = √A, elements of
/// pressure p_j at the nodes x_j give
///
///   u_z1 + u_z2 at x = (c/(πE*)) Σ_j T((x − x_j)/c) p_j,   T(d) = ∫ B(s)/|d−s| d²s,
///
/// B the element of height 1 on the lattice with cells of area 1 (Boussinesq; Johnson 3.22).
///
///   uniform   Σ h ∫ds/r over the cell's edges
///   bilinear  δ₁²δ₂² [½(x²y asinh(y/x) + xy² asinh(x/y)) − r³/6]/(cell's sides), second
///             differences by the cell's sides; rectangular lattices only
///   pyramid   linear_potential() of its six triangles
///   point     1/|d|, and T(0), instead of ∞, that makes a lattice of forces stand for a smooth
///             pressure: minus the regularised sum of 1/|d| over the lattice (Ewald's method)
///
/// and beyond Multipole::begin() the expansion. The pyramid's hexagon has the corners ±first,
/// ±second, ±(second − first). Accuracy, in units of T(0): 1e-14 for uniform and bilinear elements
/// on any lattice and for pyramids on an equilateral one, 1e-13 for pyramids with cells up to ten
/// times as long as wide; bilinear elements need a long double of 64 bits or more for it. Far away,
/// where T → 1/|d|, relative 2e-15.
class ElementPotential {
 public:
  /// Throws InvalidQuantity for cells without an area or a bilinear element that is not on a
  /// rectangular lattice.
  ElementPotential(Element element, const Lattice& lattice);

  /// T(d), d in units of c; even.
  double operator()(const Vector2& d) const;

  /// d in units of c of the node (i, j).
  Vector2 node(double i, double j) const { return i * lattice_.first + j * lattice_.second; }

 private:
  double near(const Vector2& d) const;

  Element element_;
  Lattice lattice_;  // normalised
  Multipole far_;
  double self_value_ = 0;  // of a point force
};

/// ∫ dA/r over a convex polygon whose corners are given counter-clockwise, at a point of its plane;
/// a length. A uniform pressure p on it displaces the surface by p/(πE*) times this (Love 1929 for
/// rectangles; Johnson 3.25). Finite on edges and at corners. Rounding: 1e-15 times the polygon's
/// size and the ratio of the distance to its width.
double uniform_potential(std::span<const Vector2> corners, const Vector2& at);

/// ∫ σ dA/r over a triangle whose corners are given counter-clockwise, σ linear with these values
/// at them; a length if the values are numbers. With σ(Q) = σ(P) + g·(Q−P),
///
///   ∫ σ/r dA = σ(P) Σ h ∫ds/r + g · Σ n ∫ r ds,  sums over the edges,
///
/// since (Q−P)/r is the gradient of r. Finite everywhere; rounding as above, squared ratio.
double linear_potential(const std::array<Vector2, 3>& corners, const std::array<double, 3>& values,
                        const Vector2& at);

}  // namespace point_contact
