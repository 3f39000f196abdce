// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "point_contact/solver/problem.hpp"
#include "point_contact/solver/solution.hpp"

namespace point_contact {

/// Nodal loads under a load P, by conjugate gradients within a search for the nodes in contact, on
/// a sequence of grids of the same domain. Each grid has twice the nodes per side of the one before
/// and starts from its pressure.
///
/// The contact may reach the ends of the grid. Throws InvalidQuantity if rounding prevents the
/// tolerance from being reached, ContactError if the contact does not settle.
NodalLoads solve_on_nested_grids(const Problem& problem, double load, double tolerance);

/// Interpolates the pressures of a coarse grid to a fine one; 0 outside contact.
///
/// At the edge of a contact p² rises linearly. The function therefore extrapolates p² linearly
/// across the edge, where it becomes negative, and interpolates it bilinearly.
Eigen::VectorXd prolongate(const Grid& coarse, const Eigen::VectorXd& pressure, const Grid& fine);

}  // namespace point_contact
