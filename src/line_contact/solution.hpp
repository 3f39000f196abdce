// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "contact/accuracy.hpp"
#include "elasticity/stress.hpp"
#include "line_contact/problem.hpp"

namespace line_contact {

/// A stretch of the surface in contact.
struct Region {
  double begin;  ///< x where the pressure becomes zero: p² extrapolated from the two end nodes
  double end;
  double load;  ///< carried by this stretch, force per unit length
  Eigen::Index n_nodes;
};

/// The separate stretches in contact, from left to right.
std::vector<Region> regions_in_contact(const Grid& grid, const Eigen::VectorXd& pressure);

/// A problem with the pressures at its nodes and the quantities derived from them.
struct Solution : Problem {
  Eigen::VectorXd pressure;  ///< p at the nodes, stress; 0 outside contact
  Eigen::VectorXd gap;       ///< u_z1 + u_z2 + h − δ at the nodes, length
  contact::Work work = {};
  contact::Residuals residuals = {};

  Eigen::Index n_in_contact() const { return (pressure.array() > 0).count(); }

  /// How well the grid resolves the contact, for contact::resolution_warning().
  contact::Resolution resolution() const;

  /// The resultant c Σ p, force per unit length.
  double line_load() const { return grid.spacing * pressure.sum(); }

  /// The greatest of the nodal pressures.
  double peak_pressure() const { return pressure.maxCoeff(); }

  /// a = 2√⟨x²⟩ from the second moment ⟨x²⟩ of the pressure, including the elements' own (c²/6 for
  /// triangles, c²/12 for uniform ones). Valid for the elliptic pressure of cylinders; unlike the
  /// count of nodes in contact, it does not jump by c.
  double half_width() const;

  std::vector<Region> regions() const { return regions_in_contact(grid, pressure); }

  /// The approach δ of the points of the two surfaces at x = datum, where u_z1 = u_z2 = 0; a
  /// length. It grows with ln(datum), like every displacement of a plane half-space. Throws
  /// InvalidQuantity unless the datum lies outside the contact.
  double approach(double datum) const;
};

/// ∂(u_z1 + u_z2)/∂x at any x, a slope: the sum of the closed forms of the solution's elements,
/// eq. (2) for each.
///
/// Accuracy: a few ε times the sum of the magnitudes. Throws InvalidQuantity where an element's own
/// slope is infinite: at the nodes for forces, midway between nodes for uniform elements.
double surface_slope(const Solution& solution, double x);

/// The stress at (x, z) in either body beneath a solution of triangles, whose pressure is linear
/// between nodes (elasticity::stress_beneath). Throws InvalidQuantity for other elements, whose
/// stresses jump at the surface.
elasticity::Stress stress_beneath(const Solution& solution, double x, double z);

/// The result of a method: nodal loads φ = 2c p/(πE*) and gaps at the nodes, both lengths.
struct NodalLoads {
  Eigen::VectorXd phi;
  Eigen::VectorXd gap;
  double error;  ///< of φ, relative to max φ
  contact::Work work;
};

/// Converts nodal loads to pressures, with the residuals under the load P. Throws InvalidQuantity
/// for a contact that reaches an end of the grid, because part of it may lie beyond, and for one
/// that the grid does not resolve (contact::require_resolved).
Solution to_solution(const Problem& problem, double line_load, NodalLoads loads);

}  // namespace line_contact
