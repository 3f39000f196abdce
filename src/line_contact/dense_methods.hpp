// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "contact/reference_methods.hpp"
#include "line_contact/solution.hpp"

namespace line_contact {

/// The largest dense problem: its matrix takes 8 bytes times the square, here 0.8 GB.
inline constexpr Eigen::Index max_dense_nodes = 10'000;

/// The contact as equations with coefficients of order one: element loads φ_j = 2c p_j/(πE*), a
/// length each, satisfy  Σ_j C_ij φ_j + δ = h_i  in contact and  Σ w_j φ_j = 2P/(πE*). The gaps h
/// are those beyond the least.
struct DenseSystem {
  /// Throws InvalidQuantity for P ≤ 0, an invalid problem or more than max_dense_nodes nodes.
  DenseSystem(const Problem& problem, double line_load);

  Eigen::Index size() const { return equations.weights.size(); }

  /// C_ij = T(i−j), and T(i+j) besides for the mirror image of a one-sided node j > 0.
  double coefficient(Eigen::Index i, Eigen::Index j) const {
    const double own = influence[std::abs(i - j)];
    return is_one_sided && j > 0 ? own + influence[i + j] : own;
  }

  bool is_one_sided;
  Eigen::VectorXd influence;  ///< T(0), T(1), …
  double least_gap;           ///< of h at the nodes
  contact::Equations equations;
};

/// Solves a frictionless contact under the load P (force per unit length) by the matrix inversion
/// method.
///
/// Elements of pressure p_j on the grid give u_z1 + u_z2 at node i as −(2c/(πE*)) Σ_j T(i−j) p_j,
/// for triangles T by eq. (3); eq. (1a) holds at every node in contact and c Σ w p = P. The contact
/// is found, not given: nodes in tension leave it, nodes that penetrate (against 1b) enter it,
/// until neither occurs. Cost n³ for n nodes, max_dense_nodes at most.
///
/// Accuracy against Hertz with 40 triangles over the half-width: peak 1e-4, half-width 2e-4.
/// Throws InvalidQuantity for what DenseSystem refuses and for contact that reaches the end of the
/// grid; ContactError when the contact does not settle.
Solution solve_by_matrix_inversion(const Problem& problem, double line_load);

/// Solves a frictionless contact under the load P (force per unit length) by the variational
/// method: among all pressures p ≥ 0 that carry P, that of contact makes
///
///   ½ pᵀCp + hᵀp
///
/// least, half the surfaces' elastic energy and the work against the gap h (Johnson 5.9; Kalker
/// 1972), C the compliances of the elements. No contact is assumed or searched for.
///
/// The minimum is approached by the constrained conjugate gradients of Polonsky & Keer (1999), Wear
/// 231, 206, with the dense C: a slow method, some 16 √n products for n nodes, kept as an
/// independent reference for the others. Agrees with matrix inversion to 1e-10 of the peak.
/// Throws InvalidQuantity for what DenseSystem refuses and for contact that reaches the end of the
/// grid; ContactError when the minimum is not reached in 100 √n products or more.
Solution solve_by_variational_method(const Problem& problem, double line_load);

}  // namespace line_contact
