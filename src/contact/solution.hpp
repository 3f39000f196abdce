// SPDX-License-Identifier: GPL-3.0-or-later
// How well a contact of lines or of points is solved, and what that cost.
#pragma once

#include <Eigen/Core>

namespace contact {

/// How well a solution satisfies the conditions that define it. P is a force, or one per unit
/// length between lines.
struct Residuals {
  double gap = 0;         ///< greatest |u_z1 + u_z2 + h − δ| in contact, eq. (1a), a length
  double separation = 0;  ///< greatest penetration outside, where eq. (1b) wants none, a length
  double pressure = 0;    ///< the error of the pressure as the method estimates it, a stress
  double load = 0;        ///< |resultant − P|
};

/// Those of the gap and the separation, from the pressures and the gaps at the nodes.
Residuals residuals_of_gaps(const Eigen::VectorXd& pressure, const Eigen::VectorXd& gap);

/// What a solution cost on the finest grid.
struct Work {
  int revisions = 0;         ///< of the contact until it no longer changed
  int iterations = 0;        ///< steps of the conjugate gradients
  int products = 0;          ///< products with the influence coefficients
  int preconditionings = 0;  ///< products with the preconditioner; between lines not counted
};

}  // namespace contact
