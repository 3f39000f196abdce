// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "point_contact/solver/grid.hpp"
#include "point_contact/solver/projected_cg.hpp"
#include "point_contact/solver/solution.hpp"

namespace point_contact {

/// How far a solution is to be taken, and how many threads may work on it.
struct Accuracy {
  double tolerance = 1e-8;  ///< of the nodal pressures, relative to the greatest
  int n_threads = 1;
};

/// The least tolerance that rounding allows on the finest grids.
inline constexpr double min_tolerance = 1e-12;

/// Solves the frictionless contact of two half-spaces under the load P, a force, without ever
/// forming the matrix: u_z1 + u_z2 + h = δ at the nodes in contact, p ≥ 0, and outside no
/// penetration. Cost O(n log n) and memory about 110 bytes for each of n nodes.
///
/// The nodal pressures are those of matrix inversion to accuracy.tolerance·(peak pressure). The
/// result does not depend on the number of threads. Throws InvalidQuantity for P ≤ 0, what
/// initial_gaps() refuses, a tolerance below min_tolerance, above 0.01 or out of rounding's reach,
/// and a contact that reaches the end of the grid, with a domain that holds it; ContactError if
/// the contact does not settle.
Solution solve_for_load(const Problem& problem, double load, const Accuracy& accuracy = {});

/// The same for bodies whose distant points have approached each other by δ, a length greater than
/// the least gap: in three dimensions displacements vanish far away, and no datum is needed.
Solution solve_for_approach(const Problem& problem, double approach, const Accuracy& accuracy = {});

/// Throws InvalidQuantity unless min_tolerance ≤ tolerance ≤ 0.01.
void require_tolerance(double tolerance);

/// Throws InvalidQuantity if a node at the end of the grid carries a pressure although the bodies
/// go on beyond. The message tells a side that would do.
void require_free_ends(const Problem& problem, const Eigen::VectorXd& phi, Control control,
                       double load_or_approach);

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

/// Element loads under a load P (Control::load) or an approach δ (Control::approach), by conjugate
/// gradients within a search for the nodes in contact, on a sequence of grids of the same domain,
/// each with twice the nodes a side, whose pressure the next starts from.
///
/// The contact may reach the ends of the grid. Throws InvalidQuantity if rounding keeps the
/// tolerance out of reach, ContactError if the contact does not settle.
ElementLoads solve_on_nested_grids(const Problem& problem, Control control, double load_or_approach,
                                   const Accuracy& accuracy);

/// Pressures on a fine grid from those on a coarser one of the same domain, 0 outside contact.
///
/// At the edge of a contact p² begins linearly, so it is p² that is interpolated bilinearly, after
/// it was continued linearly across the edge, where it becomes negative.
Eigen::VectorXd prolongate(const Grid& coarse, const Eigen::VectorXd& pressure, const Grid& fine);

}  // namespace point_contact
