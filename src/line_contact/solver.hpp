// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "line_contact/problem.hpp"
#include "line_contact/solution.hpp"

namespace line_contact {

/// The least tolerance that rounding allows, and the one that is taken if none is given.
inline constexpr double min_tolerance = 1e-13;
inline constexpr double default_tolerance = 1e-10;

/// Solves the contact under the load P (force per unit length) without ever forming the matrix.
///
/// Products by the fast Fourier transform, conjugate gradients with a circulant preconditioner for
/// the pressure while the contact is held, revisions of the contact outside of them, and a sequence
/// of grids, each twice as fine as the one before. Cost O(N log N), memory about 90 bytes a node.
///
/// The nodal pressures are those of matrix inversion to tolerance·(peak pressure). Throws
/// InvalidQuantity for P ≤ 0, a tolerance outside [min_tolerance, 0.01] or that rounding keeps out
/// of reach (the message says what is left), and what to_solution() refuses; ContactError if the
/// contact does not settle.
Solution solve_by_fft(const Problem& problem, double line_load,
                      double tolerance = default_tolerance);

}  // namespace line_contact
