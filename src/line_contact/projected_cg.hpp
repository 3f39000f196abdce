// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "contact/contact_search.hpp"
#include "line_contact/influence_operator.hpp"
#include "line_contact/solution.hpp"

namespace line_contact {

/// Sums rises from node to node, outwards from `start`, where the result is 0. This keeps the
/// rounding of a steep profile's large gaps far outside away from the contact.
Eigen::VectorXd added_up(const Eigen::VectorXd& rises, Eigen::Index start);

/// Solves eq. (1a) for a known contact: minimises ½φᵀ(−T)φ + hᵀφ over the element loads φ of the
/// nodes in contact at constant Σφ.
///
/// Conjugate gradients, projected on Σφ = const. and preconditioned with the inverse of a circulant
/// matrix, improve φ. Iterative refinement then recomputes the gap from its differences (eq. (2)),
/// whose rounding is n times smaller, and restarts until the pressure has reached the tolerance.
class ProjectedCg {
 public:
  /// rises: h_{i+1} − h_i between the operator's nodes. Both arguments must outlive the object.
  ProjectedCg(InfluenceOperator& influence, const Eigen::VectorXd& rises);

  /// Improves φ until its error is at most tolerance·max φ; φ is 0 outside contact. Throws
  /// InvalidQuantity for a tolerance that rounding puts out of reach.
  void solve(Eigen::VectorXd& phi, const contact::ContactMask& in_contact, double tolerance);

  /// u_z1 + u_z2 + h − δ at all nodes for the φ last solved; its mean in contact is 0.
  const Eigen::VectorXd& gap() const { return gap_; }

  /// The greatest error of φ, relative to max φ, estimated from the gaps that remain in contact.
  double error() const { return error_; }

  const contact::Work& work() const { return work_; }

 private:
  void update_gap(const Eigen::VectorXd& phi);
  void project(Eigen::VectorXd& residual);
  void improve(Eigen::VectorXd& phi, double largest_error);

  InfluenceOperator& influence_;
  const Eigen::VectorXd& rises_;
  Eigen::VectorXd contact_;         // 1 in contact, else 0
  Eigen::VectorXd uniform_answer_;  // the preconditioner times contact_
  Eigen::VectorXd gap_, residual_, correction_, direction_, product_;
  double error_ = 0;
  contact::Work work_;
};

}  // namespace line_contact
