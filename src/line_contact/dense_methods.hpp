// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "line_contact/solution.hpp"

namespace line_contact {

/// Solves a frictionless contact under the load P (force per unit length) by the matrix inversion
/// method.
///
/// Elements of pressure p_j on the grid give u_z1 + u_z2 at node i as −(2c/(πE*)) Σ_j T(i−j) p_j,
/// for triangles T by eq. (3); eq. (1a) holds at every node in contact and c Σ p = P. The contact
/// is found, not given: nodes in tension leave it, nodes that penetrate (against 1b) enter it,
/// until neither occurs. Cost n³ for n nodes, contact::max_dense_nodes at most.
///
/// Accuracy against Hertz with 40 triangles over the half-width: peak 1e-4, half-width 2e-4.
/// Throws InvalidQuantity for P ≤ 0, an invalid problem, too many nodes, and what to_solution()
/// refuses; ContactError when the contact does not settle.
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
/// Throws what solve_by_matrix_inversion() throws, and ContactError when the minimum is not reached
/// in 100 √n products or more.
Solution solve_by_variational_method(const Problem& problem, double line_load);

}  // namespace line_contact
