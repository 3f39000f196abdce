// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "elasticity/interior_stress.hpp"
#include "line_contact/solution.hpp"

namespace line_contact {

/// The tractions of a solution of triangular elements, for the stresses beneath them: pressure and
/// shear (at the nodes, stress, as it acts on the body in question; empty for none) are linear
/// between nodes in contact and their neighbours. A one-sided grid gets its mirror image.
///
/// Throws InvalidQuantity for other elements, whose stresses at the surface are infinite, and for a
/// shear on a one-sided grid.
elasticity::PiecewiseLinearTraction traction_on(const Solution& solution,
                                                const Eigen::VectorXd& shear);

}  // namespace line_contact
