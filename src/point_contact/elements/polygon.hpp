// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "point_contact/elements/lattice.hpp"

namespace point_contact {

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
