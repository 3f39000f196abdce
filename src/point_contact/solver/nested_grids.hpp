// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "point_contact/solver/problem.hpp"
#include "point_contact/solver/solution.hpp"

namespace point_contact {

/// Nodal loads under a load P, by conjugate gradients within a search for the nodes in contact, on
/// a sequence of grids of the same domain, each with twice the nodes a side, whose pressure the
/// next starts from.
///
/// The contact may reach the ends of the grid. Throws InvalidQuantity if rounding keeps the
/// tolerance out of reach, ContactError if the contact does not settle.
NodalLoads solve_on_nested_grids(const Problem& problem, double load, double tolerance);

/// Pressures on a fine grid from those on a coarser one, 0 outside contact.
///
/// At the edge of a contact p² begins linearly, so it is p² that is interpolated bilinearly, after
/// it was continued linearly across the edge, where it becomes negative.
Eigen::VectorXd prolongate(const Grid& coarse, const Eigen::VectorXd& pressure, const Grid& fine);

}  // namespace point_contact
