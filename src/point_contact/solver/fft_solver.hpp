// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "point_contact/solver/nested_grids.hpp"

namespace point_contact {

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

}  // namespace point_contact
