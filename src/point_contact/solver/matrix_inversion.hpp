// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "point_contact/solver/solution.hpp"

namespace point_contact {

/// The largest dense problem: its matrix takes 8 bytes times the square, here 0.8 GB.
inline constexpr Eigen::Index max_dense_nodes = 10'000;

/// Solves a frictionless contact under the load P, a force, with the dense matrix: eq. (1a) at
/// every node in contact and equilibrium as one linear system; nodes in tension leave the contact,
/// nodes that penetrate enter it, until neither occurs. Cost n³ for n nodes: a reference for small
/// grids.
///
/// Throws InvalidQuantity for P ≤ 0, what initial_gaps() refuses, more than max_dense_nodes nodes
/// and a contact that reaches the end of the grid; ContactError when the contact does not settle.
Solution solve_by_matrix_inversion(const Problem& problem, double load);

}  // namespace point_contact
