// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "line_contact/problem.hpp"
#include "line_contact/solution.hpp"

namespace line_contact {

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
