// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>

#include "line_contact/problem.hpp"
#include "line_contact/solution.hpp"

namespace line_contact {

/// How far a solve has come.
struct Progress {
  Eigen::Index n_nodes;  ///< of the grid being solved
  int revisions;         ///< of its contact so far
  int iterations;
};
using ProgressReport = std::function<void(const Progress&)>;

/// Element loads φ = 2c p/(πE*) on a grid, a length each, and the gap they leave.
struct NestedSolution {
  Grid grid;
  Eigen::VectorXd phi;
  Eigen::VectorXd gap;  ///< u_z1 + u_z2 + h − δ; its mean in contact is 0
  double error = 0;     ///< of φ, relative to the greatest
  contact::Work work;
};

/// Σφ for the load P: 2P/(πE*), a length. Throws InvalidQuantity if it is too large to compute
/// with.
double total_phi(const Problem& problem, double line_load);

/// Solves on a sequence of grids, each with twice the nodes of the one before, whose pressure it
/// starts from. The contact may reach the ends of the grid, whose centre it must have two sides of.
/// Throws InvalidQuantity if rounding keeps the tolerance (relative to the peak) out of reach.
NestedSolution solve_on_nested_grids(const Problem& problem, double line_load, double tolerance,
                                     const ProgressReport& report = {});

/// The same with δ, found at the node that carries most.
ElementLoads element_loads(const Problem& problem, NestedSolution nested);

/// The pressure of a coarse grid at the nodes of a fine one, none of them one-sided: linear between
/// nodes in contact, cubic where four of them are, and like a square root at the edge, which
/// regions_in_contact() places. 0 outside contact.
Eigen::VectorXd prolongate(const Grid& coarse, const Eigen::VectorXd& pressure, const Grid& fine);

}  // namespace line_contact
