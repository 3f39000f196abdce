// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "point_contact/problem.hpp"
#include "point_contact/solution.hpp"

namespace point_contact {

/// The least tolerance that rounding allows on the finest grids, and the default.
inline constexpr double min_tolerance = 1e-12;
inline constexpr double default_tolerance = 1e-8;

/// Solves the frictionless contact of two half-spaces under the load P, a force, without forming
/// the matrix: u_z1 + u_z2 + h = δ and p ≥ 0 at the nodes in contact, no penetration outside. Cost
/// O(n log n) for n nodes, memory about 110 bytes per node.
///
/// The nodal pressures agree with matrix inversion to tolerance·(peak pressure). Throws
/// InvalidQuantity for P ≤ 0, a tolerance outside [min_tolerance, 0.01] or below the rounding
/// error, and as initial_gaps() and to_solution(); ContactError if the contact does not settle.
Solution solve_for_load(const Problem& problem, double load, double tolerance = default_tolerance);

/// Solves a frictionless contact under the load P, a force, by the variational method: among all
/// pressures p ≥ 0 that carry P, it finds the one that minimises ½ pᵀCp + hᵀp (Kalker 1972; Johnson
/// §5.9).
///
/// It uses the constrained conjugate gradients of Polonsky & Keer (1999), Wear 231, 206, on a
/// single grid from a uniform pressure, with two FFT products per step: the usual method for rough
/// surfaces, and here an independent reference that does not search for a contact.
///
/// A tolerance of 1e-7 takes about 70 to 170 steps on 128² to 1024² nodes; on 1024² it then stalls
/// at 7e-8 for hundreds of steps. The iteration ends when no gap in contact and no penetration
/// exceeds tolerance·max φ, which bounds the error of the pressure's shortest waves to about the
/// same. Throws what solve_for_load() throws, and ContactError if the minimum is not reached in
/// 20000 products.
Solution solve_by_variational_method(const Problem& problem, double load,
                                     double tolerance = default_tolerance);

/// Nodal loads under a load P, by conjugate gradients within a search for the nodes in contact, on
/// a sequence of grids of the same domain. Each grid has twice the nodes per side of the one before
/// and starts from its pressure.
///
/// The contact may reach the ends of the grid. Throws InvalidQuantity if rounding prevents the
/// tolerance from being reached, ContactError if the contact does not settle.
NodalLoads solve_on_nested_grids(const Problem& problem, double load, double tolerance);

/// Interpolates the pressures of a coarse grid to a fine one; 0 outside contact.
///
/// At the edge of a contact p² rises linearly. The function therefore extrapolates p² linearly
/// across the edge, where it becomes negative, and interpolates it bilinearly.
Eigen::VectorXd prolongate(const Grid& coarse, const Eigen::VectorXd& pressure, const Grid& fine);

}  // namespace point_contact
