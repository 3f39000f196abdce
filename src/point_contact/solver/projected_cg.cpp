// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/projected_cg.hpp"

#include <algorithm>
#include <cmath>

namespace point_contact {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

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
      product_(grid.size()) {}

// begin excerpt: projected-cg-3d
void ProjectedCg::start(ContactState& state) {
  state_ = &state;
  const ContactMask& in_contact = state.in_contact;
  if (control_ == Control::load) {
    // The preconditioned uniform gap, of which a multiple is later subtracted to keep Σφ constant.
    for_rows([&](Index from, Index to) {
      for (Index i = from; i < to; ++i) product_[i] = in_contact[i] ? 1 : 0;
    });
    influence_.precondition(product_, uniform_answer_);
    ++work_.preconditionings;
    total_of_uniform_answer_ = sum([&](Index from, Index to) {
      double total = 0;
      for (Index i = from; i < to; ++i) {
        if (!in_contact[i]) uniform_answer_[i] = 0;
        total += uniform_answer_[i];
      }
      return total;
    });
  }
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

// z = M r with the residual r = −gap in contact, shifted so that Σz = 0, which changes δ and every
// gap by a constant. Keeps (r, z) as well.
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
      if (!in_contact[i]) correction_[i] = 0;
      row += correction_[i];
    }
    return row;
  });
  if (control_ == Control::load) {
    const double shift = total / total_of_uniform_answer_;
    for_rows([&](Index from, Index to) {
      const Index n = to - from;
      correction_.segment(from, n) -= shift * uniform_answer_.segment(from, n);
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
