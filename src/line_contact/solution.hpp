// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "contact/solution.hpp"
#include "line_contact/problem.hpp"

namespace line_contact {

/// A stretch of the surface in contact.
struct Region {
  double begin;  ///< x where the pressure becomes zero: p² extrapolated from the two end nodes
  double end;
  double load;  ///< what it carries, force per unit length
  Eigen::Index n_nodes;
};

/// The separate stretches in contact, from left to right; of a one-sided grid those at x ≥ 0, the
/// first with its mirror image if it begins at x = 0.
std::vector<Region> regions_in_contact(const Grid& grid, const Eigen::VectorXd& pressure);

/// Pressures at the nodes of a grid, and what follows from them.
struct Solution {
  Grid grid;
  Element element;
  Eigen::VectorXd pressure;  ///< p at the nodes, stress; 0 outside contact
  Eigen::VectorXd gap;       ///< u_z1 + u_z2 + h − δ at the nodes, length
  double pressure_per_phi;  ///< πE*/(2c): p = φ πE*/(2c) with φ, the load of an element, a length
  double approach_at_spacing;  ///< δ when lengths in the logarithm of T are taken in units of c
  contact::Work work;
  contact::Residuals residuals;

  Eigen::Index n_in_contact() const { return (pressure.array() > 0).count(); }

  /// The resultant c Σ w p, force per unit length.
  double line_load() const;

  /// The greatest of the nodal pressures.
  double peak_pressure() const { return pressure.maxCoeff(); }

  /// a = 2√⟨x²⟩ from the second moment ⟨x²⟩ of the pressure, the elements' own (c²/6 for triangles,
  /// c²/12 for uniform ones) included. Right for the elliptic pressure of cylinders; unlike the
  /// count of nodes in contact it does not jump by c.
  double half_width() const;

  /// Half the number of nodes in contact (mirror images counted), times c: good to c.
  double half_width_by_count() const;

  std::vector<Region> regions() const { return regions_in_contact(grid, pressure); }

  /// The approach δ of points of the two surfaces that lie at x = datum, where u_z1 = u_z2 = 0; a
  /// length. It grows with ln(datum), as every displacement of a half-space does. Throws
  /// InvalidQuantity unless the datum lies outside the contact.
  double approach(double datum) const;
};

/// What a method finds: element loads φ = 2c p/(πE*) and gaps at the nodes, lengths.
struct ElementLoads {
  Eigen::VectorXd phi;
  Eigen::VectorXd gap;
  double approach_at_spacing;
  double error;  ///< of φ, relative to the greatest
  contact::Work work;
};

/// The same as pressures, with the residuals under the load P.
Solution to_solution(const Problem& problem, double line_load, ElementLoads loads);

}  // namespace line_contact
