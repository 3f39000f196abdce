// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "elasticity/stress.hpp"
#include "line_contact/solution.hpp"

namespace line_contact {

/// ∂(u_z1 + u_z2)/∂x at any x, a slope: the sum of the closed forms of the solution's elements,
/// eq. (2) for each.
///
/// Accuracy: rounding, a few ε times the sum of the magnitudes. Throws InvalidQuantity where an
/// element's own slope is infinite: at the nodes of forces, and midway between them for uniform
/// elements. Not for one-sided grids, whose mirror images it leaves out.
double surface_slope(const Solution& solution, double contact_modulus, double x);

/// The stress at (x, z) beneath the elements of a solution, forces (Flamant; Johnson 2.23) and
/// uniform elements included; for triangles traction_on() is faster. Errors, accuracy and grids as
/// for surface_slope().
elasticity::Stress stress_beneath(const Solution& solution, double x, double z);

}  // namespace line_contact
