// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

}  // namespace point_contact
