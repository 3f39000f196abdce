// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "line_contact/solution.hpp"

namespace line_contact {

/// Solves a frictionless contact under the load P (force per unit length) by the variational
/// method: among all pressures p ≥ 0 that carry P, that of contact makes
///
///   ½ pᵀCp + hᵀp
///
/// least, half the surfaces' elastic energy and the work against the gap h (Johnson 5.9; Kalker
/// 1972), C the compliances of the elements. No contact is assumed or searched for.
///
/// The minimum is approached by the constrained conjugate gradients of Polonsky & Keer (1999), Wear
/// 231, 206, with the dense C: a slow method, some 16 √n products for n nodes, kept as an
/// independent reference for the others. Agrees with matrix inversion to 1e-10 of the peak.
/// Throws InvalidQuantity for what DenseSystem refuses and for contact that reaches the end of the
/// grid; ContactError when the minimum is not reached in 100 √n products or more.
Solution solve_by_variational_method(const Problem& problem, double line_load);

}  // namespace line_contact
