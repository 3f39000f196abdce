// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>

#include "elasticity/interior_stress.hpp"
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

/// The tractions of a solution of triangular elements, for the stresses beneath them: pressure and
/// shear (at the nodes, stress, as it acts on the body in question; empty for none) are linear
/// between nodes in contact and their neighbours. A one-sided grid gets its mirror image.
///
/// Throws InvalidQuantity for other elements, whose stresses at the surface are infinite, and for a
/// shear on a one-sided grid.
elasticity::PiecewiseLinearTraction traction_on(const Solution& solution,
                                                const Eigen::VectorXd& shear);

}  // namespace line_contact
