// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/projected_cg.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>

#include "system/require.hpp"

namespace contact {

using Eigen::Index;
using Eigen::VectorXd;

VectorXd added_up(const VectorXd& rises, Index start) {
  VectorXd sums(rises.size() + 1);
  sums[start] = 0;
  for (Index i = start; i < rises.size(); ++i) sums[i + 1] = sums[i] + rises[i];
  for (Index i = start; i > 0; --i) sums[i - 1] = sums[i] - rises[i - 1];
  return sums;
}

ProjectedCg::ProjectedCg(InfluenceOperator& influence, const VectorXd& rises)
    : influence_(influence), rises_(rises) {}

// The gap by adding up its differences, against its mean in contact.
void ProjectedCg::update_gap(const VectorXd& phi) {
  influence_.rises(phi, product_);
  ++work_.products;
  Index start = 0;
  phi.maxCoeff(&start);
  gap_ = added_up(rises_ - product_, start);
  gap_.array() -= (contact_.array() > 0).select(gap_.array(), 0).sum() / contact_.sum();
}

// correction = preconditioned residual with Σ = 0; the residual changes by a constant, as δ is
// free.
void ProjectedCg::project(VectorXd& residual) {
  influence_.precondition(residual, correction_);
  correction_.array() *= contact_.array();
  const double shift = correction_.sum() / uniform_answer_.sum();
  correction_ -= shift * uniform_answer_;
  residual -= shift * contact_;
}

// begin excerpt: projected-cg
void ProjectedCg::improve(VectorXd& phi, double largest_error) {
  direction_ = correction_;
  double product = residual_.dot(correction_);
  constexpr int max_steps = 200;
  for (int step = 0; step < max_steps && correction_.lpNorm<Eigen::Infinity>() > largest_error;
       ++step) {
    influence_.potentials(direction_, product_);
    product_.array() *= -contact_.array();
    const double length = product / direction_.dot(product_);
    phi += length * direction_;
    residual_ -= length * product_;
    project(residual_);
    const double next = residual_.dot(correction_);
    direction_ = correction_ + next / product * direction_;
    product = next;
    ++work_.iterations;
    ++work_.products;
  }
}

void ProjectedCg::solve(VectorXd& phi, const ContactMask& in_contact, double tolerance) {
  contact_ = in_contact.cast<double>();
  influence_.precondition(contact_, uniform_answer_);
  uniform_answer_.array() *= contact_.array();
  double previous = std::numeric_limits<double>::infinity();
  for (int fruitless = 0;;) {
    update_gap(phi);
    residual_ = (contact_.array() > 0).select(-gap_.array(), 0);
    project(residual_);
    const double largest = correction_.lpNorm<Eigen::Infinity>();
    error_ = largest / phi.maxCoeff();
    if (error_ <= tolerance) return;
    constexpr int patience = 3;
    if (!std::isfinite(error_) || (error_ > previous / 2 && ++fruitless > patience)) {
      throw sys::InvalidQuantity(
          "tolerance", tolerance,
          fmt::format("at least {:.1e}, which rounding leaves of the pressure of {} nodes", error_,
                      phi.size()));
    }
    previous = error_;
    constexpr double digits_at_a_time = 1e-7;  // rounding leaves these at any n
    improve(phi, std::max(digits_at_a_time * largest, tolerance / 2 * phi.maxCoeff()));
  }
}
// end excerpt: projected-cg

}  // namespace contact
