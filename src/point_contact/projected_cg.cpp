// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/projected_cg.hpp"

namespace point_contact {
namespace {

// The fraction θ of w that is subtracted. With θ = 1 a uniform residual would have no response.
constexpr double share_taken_off = 0.8;

}  // namespace

void ProjectedCg::start(ContactState& state) {
  state_ = &state;
  contact_ = state.in_contact.cast<double>();
  product_ = contact_;
  influence_.precondition(product_, weight_);  // w = C⁻¹1 in contact
  weight_.array() *= contact_;
  total_weight_ = weight_.sum();
  ++work_.preconditionings;
  precondition_gap();
  direction_ = correction_;
}

void ProjectedCg::step() {
  influence_.displacements(direction_, product_);              // q = T d
  const double length = decrease_ / direction_.dot(product_);  // α = (r, z)/(d, q)
  state_->phi += length * direction_;                          // φ += α d
  state_->gap += length * product_;                            // gap += α q
  const double previous = decrease_;
  precondition_gap();                                              // z = M r
  direction_ = correction_ + (decrease_ / previous) * direction_;  // d = z + β d
  ++work_.iterations;
  ++work_.products;
}

// z = M r = C⁻¹r − θ w r with the residual r = −gap in contact, shifted so that Σz = 0, which
// changes δ and every gap by a constant; M1 = (1 − θ)w. Stores (r, z) too.
void ProjectedCg::precondition_gap() {
  Eigen::VectorXd& gap = state_->gap;
  product_ = -contact_ * gap.array();
  influence_.precondition(product_, correction_);
  ++work_.preconditionings;
  correction_.array() =
      contact_ * (correction_.array() + share_taken_off * weight_.array() * gap.array());
  const double share_left = 1 - share_taken_off;
  const double shift = correction_.sum() / (share_left * total_weight_);
  correction_ -= shift * share_left * weight_;
  gap.array() += shift;
  state_->approach -= shift;
  decrease_ = -gap.dot(correction_);
  error_ = correction_.lpNorm<Eigen::Infinity>() / state_->phi.lpNorm<Eigen::Infinity>();
}

}  // namespace point_contact
