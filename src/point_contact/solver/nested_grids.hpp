// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "point_contact/solver/grid.hpp"
#include "point_contact/solver/projected_cg.hpp"
#include "point_contact/solver/solution.hpp"

namespace point_contact {

/// How far a solution is to be taken, and how many threads may work on it.
struct Accuracy {
  double tolerance = 1e-8;  ///< of the nodal pressures, relative to the greatest
  int n_threads = 1;
};

/// Element loads under a load P (Control::load) or an approach δ (Control::approach), by conjugate
/// gradients within a search for the nodes in contact, on a sequence of grids of the same domain,
/// each with twice the nodes a side, whose pressure the next starts from.
///
/// The contact may reach the ends of the grid. Throws InvalidQuantity if rounding keeps the
/// tolerance out of reach, ContactError if the contact does not settle.
ElementLoads solve_on_nested_grids(const Problem& problem, Control control, double load_or_approach,
                                   const Accuracy& accuracy);

/// Pressures on a fine grid from those on a coarser one of the same domain, 0 outside contact.
///
/// At the edge of a contact p² begins linearly, so it is p² that is interpolated bilinearly, after
/// it was continued linearly across the edge, where it becomes negative.
Eigen::VectorXd prolongate(const Grid& coarse, const Eigen::VectorXd& pressure, const Grid& fine);

}  // namespace point_contact
