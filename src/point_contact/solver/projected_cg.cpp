// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/projected_cg.hpp"

#include <algorithm>
#include <cmath>

namespace point_contact {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// The share θ of w that is taken off. All of it would leave a uniform residual without an answer.
constexpr double share_taken_off = 0.8;

}  // namespace

template <class RowSum>
double ProjectedCg::sum(const RowSum& row_sum) const {
  const Index n1 = grid_.n1;
  return team_.sum(grid_.n2, static_cast<double>(n1),
                   [&](Index row) { return row_sum(row * n1, (row + 1) * n1); });
}

template <class RowWork>
void ProjectedCg::for_rows(const RowWork& work) const {
  const Index n1 = grid_.n1;
  team_.for_rows(grid_.n2, 3 * static_cast<double>(n1),
                 [&](Index row) { work(row * n1, (row + 1) * n1); });
}

ProjectedCg::ProjectedCg(InfluenceOperator& influence, const Grid& grid, const RowTeam& team,
                         Control control)
    : influence_(influence),
      grid_(grid),
      team_(team),
      control_(control),
      correction_(grid.size()),
      direction_(grid.size()),
      product_(grid.size()),
      weight_(grid.size()) {}

// begin excerpt: projected-cg-3d
void ProjectedCg::start(ContactState& state) {
  state_ = &state;
  const ContactMask& in_contact = state.in_contact;
  // w = C⁻¹1 in contact
  for_rows([&](Index from, Index to) {
    for (Index i = from; i < to; ++i) product_[i] = in_contact[i] ? 1 : 0;
  });
  influence_.precondition(product_, weight_);
  ++work_.preconditionings;
  total_weight_ = sum([&](Index from, Index to) {
    double row = 0;
    for (Index i = from; i < to; ++i) {
      if (!in_contact[i]) weight_[i] = 0;
      row += weight_[i];
    }
    return row;
  });
  precondition_gap();
  direction_ = correction_;
}

void ProjectedCg::step() {
  VectorXd& phi = state_->phi;
  VectorXd& gap = state_->gap;
  const ContactMask& in_contact = state_->in_contact;

  // q = T d, α = (r, z)/(d, q); d is 0 outside contact
  influence_.displacements(direction_, product_);
  const double curvature = sum([&](Index from, Index to) {
    return direction_.segment(from, to - from).dot(product_.segment(from, to - from));
  });
  const double length = decrease_ / curvature;

  // φ += α d, gap += α q
  for_rows([&](Index from, Index to) {
    const Index n = to - from;
    phi.segment(from, n) += length * direction_.segment(from, n);
    gap.segment(from, n) += length * product_.segment(from, n);
  });

  // d = z + β d, β = (r, z)/(r, z)_old
  const double previous = decrease_;
  precondition_gap();
  const double share = decrease_ / previous;
  for_rows([&](Index from, Index to) {
    for (Index i = from; i < to; ++i) {
      direction_[i] = in_contact[i] ? correction_[i] + share * direction_[i] : 0;
    }
  });
  ++work_.iterations;
  ++work_.products;
}

// z = M r = C⁻¹r − θ w r with the residual r = −gap in contact, shifted so that Σz = 0, which
// changes δ and every gap by a constant; M1 = (1 − θ)w. Keeps (r, z) as well.
void ProjectedCg::precondition_gap() {
  VectorXd& gap = state_->gap;
  const ContactMask& in_contact = state_->in_contact;
  for_rows([&](Index from, Index to) {
    for (Index i = from; i < to; ++i) product_[i] = in_contact[i] ? -gap[i] : 0;
  });
  influence_.precondition(product_, correction_);
  ++work_.preconditionings;
  const double total = sum([&](Index from, Index to) {
    double row = 0;
    for (Index i = from; i < to; ++i) {
      correction_[i] = in_contact[i] ? correction_[i] + share_taken_off * weight_[i] * gap[i] : 0;
      row += correction_[i];
    }
    return row;
  });
  if (control_ == Control::load) {
    const double share_left = 1 - share_taken_off;
    const double shift = total / (share_left * total_weight_);
    for_rows([&](Index from, Index to) {
      const Index n = to - from;
      correction_.segment(from, n) -= shift * share_left * weight_.segment(from, n);
      gap.segment(from, n).array() += shift;
    });
    state_->approach -= shift;
  }
  decrease_ = sum([&](Index from, Index to) {
    double row = 0;
    for (Index i = from; i < to; ++i) {
      if (in_contact[i]) row -= gap[i] * correction_[i];
    }
    return row;
  });
  const auto largest = [&](const VectorXd& values) {
    return team_.max(grid_.n2, static_cast<double>(grid_.n1), [&](Index row) {
      return values.segment(row * grid_.n1, grid_.n1).lpNorm<Eigen::Infinity>();
    });
  };
  error_ = largest(correction_) / largest(state_->phi);
}
// end excerpt: projected-cg-3d

}  // namespace point_contact
