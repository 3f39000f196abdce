// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "contact/contact_search.hpp"
#include "contact/solution.hpp"
#include "point_contact/solver/influence_operator.hpp"

namespace point_contact {

using contact::ContactMask;

/// Nodal loads, the gap they leave, and which nodes are taken to be in contact.
struct ContactState {
  Eigen::VectorXd phi;  ///< 0 outside contact
  Eigen::VectorXd gap;  ///< Tφ + h − δ
  ContactMask in_contact;
  double approach = 0;  ///< δ
};

/// Eq. (1a) for nodes whose contact is known: minimises ½φᵀTφ + (h−δ)ᵀφ over the loads φ of the
/// nodes in contact while Σφ stays what it is; δ adapts itself.
///
/// Conjugate gradients, preconditioned by M = C⁻¹ − θ diag(w). The inverse C⁻¹ of the circulant
/// matrix takes the displacements to be zero outside contact and answers a jump at its edge with
/// large pressures, although displacements outside are free; w = C⁻¹1 over the contact is the
/// answer to a jump of 1, and most of it is taken off. With θ = 0 the number of steps grows with
/// ln N.
///
/// As each product gives the displacements at all nodes, the gap is kept up with the pressure, in
/// contact and outside, and can be looked at after any step.
class ProjectedCg {
 public:
  explicit ProjectedCg(InfluenceOperator& influence) : influence_(influence) {}

  /// Begins for the contact, φ and gap of this state, which stays the one that step() improves.
  void start(ContactState& state);

  /// One step: one product, one preconditioning.
  void step();

  /// What the preconditioner makes of the gap in contact, greatest and relative to max φ: an
  /// estimate of the error of φ.
  double error() const { return error_; }

  /// Steps and preconditionings since the construction, and the products of the steps.
  const contact::Work& work() const { return work_; }

 private:
  void precondition_gap();

  InfluenceOperator& influence_;
  ContactState* state_ = nullptr;
  Eigen::ArrayXd contact_;  // 1 in contact, else 0
  Eigen::VectorXd correction_, direction_, product_;
  Eigen::VectorXd weight_;  // w
  double total_weight_ = 0;
  double decrease_ = 0;  // (residual, correction)
  double error_ = 0;
  contact::Work work_;
};

}  // namespace point_contact
