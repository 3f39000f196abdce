// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <stdexcept>

#include "contact/cylinder_pair.hpp"
#include "contact/grid.hpp"

namespace contact {

/// A contact that was not solved. what() says why and what would help.
class ContactError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// How well a solution satisfies the conditions that define it.
struct Residuals {
  double contact;     ///< greatest |u_z1 + u_z2 + h − δ| in contact, eq. (1a), a length
  double separation;  ///< greatest penetration outside, where eq. (1b) wants none, a length
  double pressure;    ///< greatest tension in contact, a stress
  double load;        ///< |c Σp − P|, force per unit length
};

/// Pressures at the nodes of a grid, and what follows from them.
struct Solution {
  Grid grid;
  Eigen::VectorXd pressure;    ///< p at the nodes, stress; linear between
  Eigen::VectorXd gap;         ///< u_z1 + u_z2 + h − δ at the nodes, length
  Eigen::VectorXd phi;         ///< φ = 2c p/(πE*) at the nodes, a length: the factor of T(k)
  double approach_at_spacing;  ///< δ when lengths in the logarithm of T are taken in units of c
  Eigen::Index n_in_contact;
  int n_solves;  ///< linear systems solved until the contact no longer changed
  Residuals residuals;

  /// The resultant c Σp, force per unit length.
  double line_load() const { return grid.spacing * pressure.sum(); }

  /// The greatest pressure of the piecewise linear distribution, which is at a node.
  double peak_pressure() const { return pressure.maxCoeff(); }

  /// a = 2√⟨x²⟩ from the second moment ⟨x²⟩ of the piecewise linear pressure, which includes c²/6
  /// for the triangles' own width. Right for the elliptic pressure of cylinders; unlike the count
  /// of nodes in contact it does not jump by c.
  double half_width() const;

  /// The approach δ of points of the two surfaces that lie at x = datum, where u_z1 = u_z2 = 0; a
  /// length. It grows with ln(datum), as every displacement of a half-space does. Throws
  /// InvalidQuantity unless the datum lies outside the grid.
  double approach(double datum) const;
};

/// Solves the frictionless contact of two cylinders by the matrix inversion method.
///
/// Overlapping triangles of pressure p_j on the grid give u_z1 + u_z2 at node i as
/// −(2c/(πE*)) Σ_j T(i−j) p_j, T by eq. (3); eq. (1a) holds at every node in contact and c Σp = P.
/// The contact is found, not given: nodes in tension leave it, nodes that penetrate (against 1b)
/// enter it, until neither occurs. line_load P > 0, force per unit length.
///
/// Accuracy against Hertz with 40 elements over the half-width: peak 1e-4, half-width 2e-4.
/// Throws InvalidQuantity for a load that is not > 0, and ContactError when the contact reaches
/// the end of the grid or does not settle.
Solution solve_by_matrix_inversion(const CylinderPair& cylinders, double line_load,
                                   const Grid& grid);

}  // namespace contact
