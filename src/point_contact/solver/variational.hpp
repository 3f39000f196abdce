// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "point_contact/solver/nested_grids.hpp"
#include "point_contact/solver/solution.hpp"

namespace point_contact {

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
