// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "contact/contact_search.hpp"
#include "point_contact/solver/grid.hpp"
#include "point_contact/solver/influence_operator.hpp"
#include "point_contact/solver/solution.hpp"

namespace point_contact {

using contact::ContactMask;

/// What is held while the pressure is sought.
enum class Control {
  load,     ///< Σφ; the approach adapts itself
  approach  ///< δ; the load adapts itself
};

/// Element loads, the gap they leave, and which nodes are taken to be in contact.
struct ContactState {
  Eigen::VectorXd phi;  ///< 0 outside contact
  Eigen::VectorXd gap;  ///< Tφ + h − δ
  ContactMask in_contact;
  double approach = 0;  ///< δ
};

/// Eq. (1a) for nodes whose contact is known: minimises ½φᵀTφ + (h−δ)ᵀφ over the element loads φ of
/// the nodes in contact, under a given δ or while Σφ stays what it is.
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
  ProjectedCg(InfluenceOperator& influence, const Grid& grid, const RowTeam& team, Control control);

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
  template <class RowSum>
  double sum(const RowSum& row_sum) const;
  template <class RowWork>
  void for_rows(const RowWork& work) const;

  InfluenceOperator& influence_;
  const Grid& grid_;
  const RowTeam& team_;
  Control control_;
  ContactState* state_ = nullptr;
  Eigen::VectorXd correction_, direction_, product_;
  Eigen::VectorXd weight_;  // w
  double total_weight_ = 0;
  double decrease_ = 0;  // (residual, correction)
  double error_ = 0;
  contact::Work work_;
};

}  // namespace point_contact
