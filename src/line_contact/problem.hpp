// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "line_contact/element.hpp"
#include "line_contact/grid.hpp"
#include "line_contact/profile.hpp"

namespace line_contact {

/// Two bodies to be pressed together, and the elements to find their pressure with. What remains
/// to be said is how hard: by the load P, or by the approach δ.
///
/// Where the bodies touch, u_z1 + u_z2 + h = δ and p ≥ 0. This is eq. (1a) of the paper.
/// Elsewhere u_z1 + u_z2 + h > δ and p = 0. This is eq. (1b) of the paper.
struct Problem {
  Profile profile;
  double contact_modulus;  ///< E*, a stress
  Grid grid;
  Element element = Element::triangular;
};

/// Lengths whose squares are doubles too, with room to add them up.
inline constexpr double largest_length = 1e100;

/// Throws InvalidQuantity unless E* > 0, the grid lies within a measured profile, the profile of a
/// one-sided grid is symmetric, all gaps are less than largest_length, and the largest of them is 0
/// or at least 1e-130, so that its square is no rounded zero.
void require_valid(const Problem& problem);

}  // namespace line_contact
