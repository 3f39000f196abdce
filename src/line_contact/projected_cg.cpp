// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/projected_cg.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>

#include "system/require.hpp"

namespace line_contact {

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

// Sums the gap g = h − δ − Tφ from its differences; δ makes its mean in contact zero.
void ProjectedCg::update_gap(const VectorXd& phi) {
  influence_.differences(phi, product_);  // (Tφ)_{i+1} − (Tφ)_i
  ++work_.products;
  Index start = 0;
  phi.maxCoeff(&start);
  gap_ = added_up(rises_ - product_, start);  // g − g_start
  gap_.array() -= (contact_.array() > 0).select(gap_.array(), 0).sum() / contact_.sum();
}

// Preconditions the residual r into the correction s with Σs = 0, which keeps the load. With the
// preconditioner M and the vector of ones 1, both in contact, r changes by a multiple of 1: a
// change of the approach δ.
void ProjectedCg::project(VectorXd& residual) {
  influence_.precondition(residual, correction_);
  correction_.array() *= contact_.array();                         // s = M r
  const double shift = correction_.sum() / uniform_answer_.sum();  // Σs / ΣM1
  correction_ -= shift * uniform_answer_;                          // s = M (r − shift 1)
  residual -= shift * contact_;                                    // r = r − shift 1
}

// Conjugate gradients for A φ = −g in contact, A = −T between its nodes, from r, s = M r and φ.
void ProjectedCg::improve(VectorXd& phi, double largest_error) {
  direction_ = correction_;                     // d = s
  double product = residual_.dot(correction_);  // ρ = (r, s)
  constexpr int max_steps = 200;
  for (int step = 0; step < max_steps && correction_.lpNorm<Eigen::Infinity>() > largest_error;
       ++step) {
    influence_.potentials(direction_, product_);
    product_.array() *= -contact_.array();                     // q = A d
    const double length = product / direction_.dot(product_);  // α = ρ / (d, q)
    phi += length * direction_;                                // φ = φ + α d
    residual_ -= length * product_;                            // r = r − α q
    project(residual_);                                        // s = M r, Σs = 0
    const double next = residual_.dot(correction_);            // ρ_new = (r, s)
    direction_ = correction_ + next / product * direction_;    // d = s + (ρ_new / ρ) d
    product = next;
    ++work_.iterations;
    ++work_.products;
  }
}

void ProjectedCg::solve(VectorXd& phi, const contact::ContactMask& in_contact, double tolerance) {
  contact_ = in_contact.cast<double>();
  influence_.precondition(contact_, uniform_answer_);  // M1
  uniform_answer_.array() *= contact_.array();
  double previous = std::numeric_limits<double>::infinity();
  for (int n_stalled = 0;;) {
    // Recompute the residual, and stop if its correction is small enough
    update_gap(phi);
    residual_ = (contact_.array() > 0).select(-gap_.array(), 0);  // r = −g
    project(residual_);                                           // s = M r, Σs = 0
    const double largest = correction_.lpNorm<Eigen::Infinity>();
    error_ = largest / phi.maxCoeff();
    if (error_ <= tolerance) return;

    // Give up when rounding prevents the error from halving. After a start from a coarse grid,
    // convergence may be slow once or twice before that.
    constexpr int max_stalled = 3;
    if (!std::isfinite(error_) || (error_ > previous / 2 && ++n_stalled > max_stalled)) {
      throw sys::InvalidQuantity(
          "tolerance", tolerance,
          fmt::format("at least {:.1e}, the rounding error of the pressure at {} nodes", error_,
                      phi.size()));
    }
    previous = error_;

    // Gain seven digits, which the rounding of T allows at any n
    constexpr double digits_at_a_time = 1e-7;
    improve(phi, std::max(digits_at_a_time * largest, tolerance / 2 * phi.maxCoeff()));
  }
}

}  // namespace line_contact
