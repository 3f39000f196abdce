// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "point_contact/solver/nested_grids.hpp"
#include "point_contact/solver/solution.hpp"

namespace point_contact {

/// The largest dense problem: its matrix takes 8 bytes times the square, here 0.8 GB.
inline constexpr Eigen::Index max_dense_nodes = 10'000;

/// Solves a frictionless contact under the load P, a force, with the dense matrix: eq. (1a) at
/// every node in contact and equilibrium as one linear system; nodes in tension leave the contact,
/// nodes that penetrate enter it, until neither occurs. Cost n³ for n nodes: a reference for small
/// grids.
///
/// Throws InvalidQuantity for P ≤ 0, what initial_gaps() refuses, more than max_dense_nodes nodes
/// and a contact that reaches the end of the grid; ContactError when the contact does not settle.
Solution solve_by_matrix_inversion(const Problem& problem, double load);

/// Solves a frictionless contact under the load P, a force, by the variational method: among all
/// pressures p ≥ 0 that carry P, that of contact makes ½ pᵀCp + hᵀp least (Kalker 1972; Johnson
/// §5.9).
///
/// The minimum is approached by the constrained conjugate gradients of Polonsky & Keer (1999), Wear
/// 231, 206, on the one grid, from a uniform pressure, with two products a step by FFT: the usual
/// method for rough surfaces, and here an independent reference that never looks for a contact.
///
/// To a tolerance of 1e-7 it takes some 70 to 170 steps on 128² to 1024² nodes; on 1024² it then
/// stays at 7e-8 for hundreds of steps. It ends when no gap in contact and no penetration exceed
/// accuracy.tolerance·max φ, of which the shortest waves of the pressure have about the same.
/// Throws what solve_for_load() throws, and ContactError when the minimum is not reached in 20000
/// products.
Solution solve_by_variational_method(const Problem& problem, double load,
                                     const Accuracy& accuracy = {});

}  // namespace point_contact
