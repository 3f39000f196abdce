// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "contact/accuracy.hpp"
#include "contact/contact_search.hpp"
#include "point_contact/influence_operator.hpp"

namespace point_contact {

using contact::ContactMask;

/// Nodal loads, the gap they leave, and the nodes assumed to be in contact.
struct ContactState {
  Eigen::VectorXd phi;  ///< 0 outside contact
  Eigen::VectorXd gap;  ///< Tφ + h − δ
  ContactMask in_contact;
  double approach = 0;  ///< δ
};

/// Solves eq. (1a) for a known contact: minimises ½φᵀTφ + (h−δ)ᵀφ over the loads φ of the nodes in
/// contact at constant Σφ; δ follows.
///
/// Conjugate gradients with the preconditioner M = C⁻¹ − θ diag(w). The inverse C⁻¹ of the
/// circulant matrix assumes zero displacement outside contact, so it responds to a jump at the edge
/// with large pressures, although displacements outside are free. w = C⁻¹1 over the contact is the
/// response to a jump of 1, and most of it is subtracted. With θ = 0 the number of steps grows with
/// ln N.
///
/// Because each product gives the displacements at all nodes, the gap is up to date after every
/// step, in contact and outside.
class ProjectedCg {
 public:
  explicit ProjectedCg(InfluenceOperator& influence) : influence_(influence) {}

  /// Starts from the contact, φ and gap of this state; step() improves the same object, which must
  /// outlive its use.
  void start(ContactState& state);

  /// One step: one product, one preconditioning.
  void step();

  /// The greatest error of φ relative to max φ, estimated by preconditioning the gap in contact.
  double error() const { return error_; }

  /// Steps, their products and preconditionings since construction.
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
