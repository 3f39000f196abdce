// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "line_contact/problem.hpp"
#include "line_contact/solution.hpp"

namespace line_contact {

/// Solves a frictionless contact under the load P (force per unit length) by the matrix inversion
/// method.
///
/// Elements of pressure p_j on the grid give u_z1 + u_z2 at node i as −(2c/(πE*)) Σ_j T(i−j) p_j,
/// with T from eq. (3) for triangles; eq. (1a) holds at every node in contact and c Σ p = P. Nodes
/// in tension leave the contact and nodes that penetrate, violating eq. (1b), enter it until
/// neither occurs. Cost n³ for n nodes, at most contact::max_dense_nodes.
///
/// Relative error against Hertz with 40 triangles over the half-width: peak 1e-4, half-width 2e-4.
/// Throws InvalidQuantity for P ≤ 0, an invalid problem or too many nodes, ContactError if the
/// contact does not settle, and whatever to_solution() throws.
Solution solve_by_matrix_inversion(const Problem& problem, double line_load);

/// Solves a frictionless contact under the load P (force per unit length) by the variational
/// method: among all pressures p ≥ 0 that carry P, it finds the one that minimises
///
///   ½ pᵀCp + hᵀp
///
/// the elastic energy of the surfaces plus the work against the gap h (Johnson 5.9; Kalker 1972),
/// with C the compliances of the elements. It assumes no contact and searches for none.
///
/// It uses the constrained conjugate gradients of Polonsky & Keer (1999), Wear 231, 206, with the
/// dense C: a slow method, about 16 √n products for n nodes, kept as an independent reference for
/// the others. It agrees with matrix inversion to 1e-10 of the peak. Throws what
/// solve_by_matrix_inversion() throws, and ContactError if the minimum is not reached in
/// 1000 + 400 √n products.
Solution solve_by_variational_method(const Problem& problem, double line_load);

/// The least tolerance that rounding allows, and the default.
inline constexpr double min_tolerance = 1e-13;
inline constexpr double default_tolerance = 1e-10;

/// Solves the contact under the load P (force per unit length) without forming the matrix.
///
/// Products use the fast Fourier transform. Conjugate gradients with a circulant preconditioner
/// find the pressure of a fixed contact, an outer loop revises the contact, and a sequence of
/// grids, each twice as fine as the one before, provides the first guess. Cost O(N log N), memory
/// about 90 bytes per node.
///
/// The nodal pressures agree with matrix inversion to tolerance·(peak pressure). Throws
/// InvalidQuantity for P ≤ 0, a tolerance outside [min_tolerance, 0.01] or below the rounding error
/// (which the message gives), ContactError if the contact does not settle, and whatever
/// to_solution() throws.
Solution solve_by_fft(const Problem& problem, double line_load,
                      double tolerance = default_tolerance);

}  // namespace line_contact
