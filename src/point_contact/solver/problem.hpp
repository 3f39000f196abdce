// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "point_contact/bodies/profile.hpp"
#include "point_contact/elements/element.hpp"
#include "point_contact/solver/grid.hpp"
#include "point_contact/solver/row_team.hpp"

namespace point_contact {

/// Two bodies to be pressed together, and the elements to find their pressure with. What remains
/// to be said is how hard: by the load, or by the approach.
struct Problem {
  Profile profile;
  double contact_modulus;  ///< E*, a stress
  Grid grid;
  Element element = Element::pyramid;
};

/// Lengths whose squares are doubles too, with room to add them up.
inline constexpr double largest_length = 1e100;

/// h at the nodes. Throws InvalidQuantity unless E* > 0, there is memory for the grid, it lies
/// within a measured surface, and there is a body with h < largest_length at one node at least.
Eigen::VectorXd initial_gaps(const Problem& problem, const RowTeam& team);

/// Throws InvalidQuantity if a contact on n1 × n2 nodes needs more memory than this machine has;
/// the message says how much.
void require_memory(Eigen::Index n1, Eigen::Index n2);

}  // namespace point_contact
