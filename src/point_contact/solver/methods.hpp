// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "point_contact/solver/grid.hpp"
#include "point_contact/solver/solution.hpp"

namespace point_contact {

/// The least tolerance that rounding allows on the finest grids, and the one that is taken if none
/// is given.
inline constexpr double min_tolerance = 1e-12;
inline constexpr double default_tolerance = 1e-8;

/// Solves the frictionless contact of two half-spaces under the load P, a force, without ever
/// forming the matrix: u_z1 + u_z2 + h = δ at the nodes in contact, p ≥ 0, and outside no
/// penetration. Cost O(n log n) and memory about 110 bytes for each of n nodes.
///
/// The nodal pressures are those of matrix inversion to tolerance·(peak pressure). Throws
/// InvalidQuantity for P ≤ 0, what initial_gaps() and to_solution() refuse, and a tolerance that is
/// not from min_tolerance to 0.01 or out of rounding's reach; ContactError if the contact does not
/// settle.
Solution solve_for_load(const Problem& problem, double load, double tolerance = default_tolerance);

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
/// tolerance·max φ, of which the shortest waves of the pressure have about the same.
/// Throws what solve_for_load() throws, and ContactError when the minimum is not reached in 20000
/// products.
Solution solve_by_variational_method(const Problem& problem, double load,
                                     double tolerance = default_tolerance);

}  // namespace point_contact
