// SPDX-License-Identifier: GPL-3.0-or-later
// The accuracy and the cost of a solved line or point contact.
#pragma once

#include <Eigen/Core>

namespace contact {

/// How well a solution satisfies the conditions that define it. P is a force; for a line contact, a
/// force per unit length.
struct Residuals {
  double gap = 0;         ///< greatest |u_z1 + u_z2 + h − δ| in contact, eq. (1a), a length
  double separation = 0;  ///< greatest penetration outside, against eq. (1b), a length
  double pressure = 0;    ///< the method's estimate of its error in pressure, a stress
  double load = 0;        ///< |resultant − P|
};

/// The residuals of gap and separation, from the pressures and gaps at the nodes.
Residuals residuals_of_gaps(const Eigen::VectorXd& pressure, const Eigen::VectorXd& gap);

/// The cost of a solution on the finest grid.
struct Work {
  int revisions = 0;         ///< revisions of the contact until it settled
  int iterations = 0;        ///< steps of the conjugate gradients
  int products = 0;          ///< products with the influence coefficients
  int preconditionings = 0;  ///< products with the preconditioner; not counted for line contacts
};

}  // namespace contact
