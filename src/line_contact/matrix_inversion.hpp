// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "line_contact/solution.hpp"

namespace line_contact {

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

}  // namespace line_contact
