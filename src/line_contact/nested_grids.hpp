// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "line_contact/problem.hpp"
#include "line_contact/solution.hpp"

namespace line_contact {

/// Σφ for the load P: 2P/(πE*), a length. Throws InvalidQuantity for P ≤ 0 and if Σφ is not less
/// than contact::largest_length.
double total_phi(const Problem& problem, double line_load);

/// Solves on a sequence of grids, each with twice the nodes of the one before and starting from its
/// pressure. The mean gap in contact is 0. The contact may reach the ends of the grid. Throws
/// InvalidQuantity if rounding prevents the tolerance (relative to the peak) from being reached,
/// and ContactError if the contact does not settle.
NodalLoads solve_on_nested_grids(const Problem& problem, double line_load, double tolerance);

/// Interpolates the pressure of a coarse grid to the nodes of a fine one: linearly between two
/// nodes in contact, cubically where four in a row are in contact, and as a square root at the
/// edge, whose position regions_in_contact() gives. 0 outside contact.
Eigen::VectorXd prolongate(const Grid& coarse, const Eigen::VectorXd& pressure, const Grid& fine);

}  // namespace line_contact
