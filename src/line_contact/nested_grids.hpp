// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "line_contact/problem.hpp"
#include "line_contact/solution.hpp"

namespace line_contact {

/// Σφ for the load P: 2P/(πE*), a length. Throws InvalidQuantity for P ≤ 0 and if it is too large
/// to compute with.
double total_phi(const Problem& problem, double line_load);

/// Solves on a sequence of grids, each with twice the nodes of the one before, whose pressure it
/// starts from. The mean gap in contact is 0. The contact may reach the ends of the grid.
/// Throws InvalidQuantity if rounding keeps the tolerance (relative to the peak) out of reach, and
/// ContactError if the contact does not settle.
NodalLoads solve_on_nested_grids(const Problem& problem, double line_load, double tolerance);

/// The pressure of a coarse grid at the nodes of a fine one: linear between nodes in contact, cubic
/// where four of them are, and like a square root at the edge, which regions_in_contact() places.
/// 0 outside contact.
Eigen::VectorXd prolongate(const Grid& coarse, const Eigen::VectorXd& pressure, const Grid& fine);

}  // namespace line_contact
