// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "contact/accuracy.hpp"
#include "point_contact/problem.hpp"

namespace point_contact {

/// A problem with the pressures at its nodes and the quantities derived from them.
struct Solution : Problem {
  Eigen::VectorXd pressure;  ///< p at the nodes, a stress; 0 outside contact
  Eigen::VectorXd gap;       ///< u_z1 + u_z2 + h − δ at the nodes, a length
  double approach = 0;       ///< δ of points far away in the two bodies, a length
  contact::Work work = {};
  contact::Residuals residuals = {};

  Eigen::Index n_in_contact() const { return (pressure.array() > 0).count(); }

  /// How well the grid resolves the contact, for contact::resolution_warning(). n_across is the
  /// least of the rows in contact, the columns in contact, and the diameter of a circle of the
  /// contact's area.
  contact::Resolution resolution() const;

  /// The resultant, cell area times Σp, a force.
  double load() const { return grid.cell_area() * pressure.sum(); }

  /// The greatest of the nodal pressures.
  double peak_pressure() const { return pressure.maxCoeff(); }

  /// The area of the cells of the nodes in contact.
  double contact_area() const { return grid.cell_area() * static_cast<double>(n_in_contact()); }

  /// The semi-axes a ≥ b of the contact from the pressure's second moments M, including the
  /// elements' own: a² and b² are 5 times the eigenvalues of M. Valid for the pressure of
  /// ellipsoids; unlike the count of nodes, they do not jump by c.
  Vector2 semi_axes() const;

  /// The semi-axes a ≥ b of the ellipse with the second moments of the contact area, for other
  /// bodies. Accurate to a fraction of c.
  Vector2 area_semi_axes() const;
};

/// The result of a method: nodal loads φ = c p/(πE*) and gaps at the nodes, both lengths.
struct NodalLoads {
  Eigen::VectorXd phi;
  Eigen::VectorXd gap;
  double approach = 0;
  double error = 0;  ///< of φ, relative to max φ
  contact::Work work;
};

/// Converts nodal loads to pressures, with the residuals under the load P. Throws InvalidQuantity
/// for a contact that reaches an end of the grid, because part of it may lie beyond, and for one
/// that the grid does not resolve (contact::require_resolved).
Solution to_solution(const Problem& problem, double load, NodalLoads loads);

/// A connected part of the contact.
struct Region {
  Vector2 centre;  ///< of its pressure
  double load;     ///< carried by this region, a force
  double area;     ///< of its nodes' cells
  Eigen::Index n_nodes;
};

/// The regions in contact in order of falling load. The neighbours of a node are the six corners of
/// a pyramid's hexagon.
std::vector<Region> regions(const Solution& solution);

}  // namespace point_contact
