// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "point_contact/bodies/profile.hpp"
#include "point_contact/elements/element.hpp"
#include "point_contact/solver/grid.hpp"

namespace point_contact {

/// Two bodies to be pressed together, and the elements that represent their pressure.
struct Problem {
  Profile profile;
  double contact_modulus;  ///< E*, a stress
  Grid grid;
  Element element = Element::pyramid;
};

/// h at the nodes. Throws InvalidQuantity unless E* > 0, the grid has min_nodes to max_nodes per
/// side and lies within a measured surface, and all gaps are less than contact::largest_length.
Eigen::VectorXd initial_gaps(const Problem& problem);

/// Σφ = P/(πE*c) for the load P, with nodal loads φ = c p/(πE*); a length. Throws InvalidQuantity
/// for P ≤ 0 and if Σφ is not less than contact::largest_length.
double total_phi(const Problem& problem, double load);

}  // namespace point_contact
