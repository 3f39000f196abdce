// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "contact/limits.hpp"
#include "contact/solution.hpp"
#include "point_contact/solver/problem.hpp"

namespace point_contact {

/// A problem with the pressures at its nodes, and what follows from them.
struct Solution : Problem {
  Eigen::VectorXd pressure;  ///< p at the nodes, a stress; 0 outside contact
  Eigen::VectorXd gap;       ///< u_z1 + u_z2 + h − δ at the nodes, a length
  double approach = 0;       ///< δ of points far away in the two bodies, a length
  contact::Work work = {};
  contact::Residuals residuals = {};

  Eigen::Index n_in_contact() const { return (pressure.array() > 0).count(); }

  /// How the contact lies on the grid, for contact::resolution_warning(). Across are the rows or
  /// columns in contact, whichever are fewer, or the diameter of a circle of the contact's area if
  /// that is less.
  contact::Resolution resolution() const;

  /// The resultant, cell area times Σp, a force.
  double load() const { return grid.cell_area() * pressure.sum(); }

  /// The greatest of the nodal pressures.
  double peak_pressure() const { return pressure.maxCoeff(); }

  /// The area of the cells of the nodes in contact.
  double contact_area() const { return grid.cell_area() * static_cast<double>(n_in_contact()); }

  /// The semi-axes a ≥ b of the contact from the pressure's second moments M, a² and b² = 5 times
  /// the eigenvalues of M: right for the pressure of ellipsoids. The elements' own moments are
  /// included. Unlike the count of nodes they do not jump by c.
  Vector2 semi_axes() const;

  /// The semi-axes a ≥ b of the ellipse that has the second moments of the area in contact, for
  /// other bodies. Right to a fraction of c.
  Vector2 area_semi_axes() const;
};

/// What a method finds: nodal loads φ = c p/(πE*) and gaps at the nodes, lengths.
struct NodalLoads {
  Eigen::VectorXd phi;
  Eigen::VectorXd gap;
  double approach = 0;
  double error = 0;  ///< of φ, relative to the greatest
  contact::Work work;
};

/// The same as pressures, with the residuals under the load P. Throws InvalidQuantity for a contact
/// that reaches an end of the grid, although the bodies go on beyond, or that is not resolved
/// (contact::require_resolved).
Solution to_solution(const Problem& problem, double load, NodalLoads loads);

/// A part of the surface in contact whose nodes are neighbours of one another.
struct Region {
  Vector2 centre;  ///< of its pressure
  double load;     ///< what it carries, a force
  double area;     ///< of its nodes' cells
  Eigen::Index n_nodes;
};

/// The regions in contact, those that carry most first. Neighbours of a node are the six corners of
/// a pyramid's hexagon.
std::vector<Region> regions(const Solution& solution);

}  // namespace point_contact
