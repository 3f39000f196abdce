// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>

#include "line_contact/nested_grids.hpp"
#include "line_contact/problem.hpp"
#include "line_contact/solution.hpp"

namespace line_contact {

/// The least tolerance that rounding allows, and the one that is asked for if nothing is said.
inline constexpr double min_tolerance = 1e-13;
inline constexpr double default_tolerance = 1e-10;

/// Throws InvalidQuantity unless min_tolerance ≤ tolerance < 0.01.
double require_tolerance(double tolerance);

/// Solves the contact under the load P (force per unit length) without ever forming the matrix.
///
/// Products by the fast Fourier transform, conjugate gradients with a circulant preconditioner for
/// the pressure while the contact is held, revisions of the contact outside of them, and a sequence
/// of grids, each twice as fine as the one before. Cost O(N log N), memory about 90 bytes a node.
///
/// The nodal pressures are those of matrix inversion to tolerance·(peak pressure). Throws
/// InvalidQuantity for P ≤ 0, a tolerance that require_tolerance refuses or that rounding keeps out
/// of reach (the message says what is left), or contact that reaches the end of the grid.
Solution solve_by_fft(const Problem& problem, double line_load,
                      double tolerance = default_tolerance, const ProgressReport& report = {});

/// Throws InvalidQuantity if contact reaches an end of the grid, which then hides part of it: the
/// pressures (in any unit) are > 0 there. It says what domain the load needs, found on a coarse
/// grid, or that the profile is not given that far out.
void require_free_ends(const Problem& problem, const Eigen::VectorXd& pressure, double line_load);

/// A method that solves a problem under a given load.
using Method = std::function<Solution(const Problem&, double line_load)>;

/// Solves the contact of two bodies that have approached each other by δ, measured where the
/// surfaces lie at x = datum (both lengths; u_z1 = u_z2 = 0 there).
///
/// δ(P) rises with the load P; the root is found by the secant rule for ln P against ln(δ − h_min),
/// on a coarse grid first. The load is right to 1e-12 or, if that is worse, to the method's own
/// tolerance. Throws InvalidQuantity if δ is not greater than the least gap (the bodies do not
/// touch then) or the datum lies in the grid, and what the method throws.
Solution solve_for_approach(const Problem& problem, double approach, double datum,
                            const Method& method);

}  // namespace line_contact
