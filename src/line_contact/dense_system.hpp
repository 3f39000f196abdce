// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "line_contact/problem.hpp"

namespace line_contact {

/// The largest dense problem: its matrix takes 8 bytes times the square, here 0.8 GB.
inline constexpr Eigen::Index max_dense_nodes = 10'000;

/// The contact as equations with coefficients of order one: element loads φ_j = 2c p_j/(πE*), a
/// length each, satisfy  Σ_j C_ij φ_j + δ = h_i  in contact and  Σ w_j φ_j = 2P/(πE*).
class DenseSystem {
 public:
  /// Throws InvalidQuantity for P ≤ 0, an invalid problem or more than max_dense_nodes nodes.
  DenseSystem(const Problem& problem, double line_load);

  Eigen::Index size() const { return initial_gap_.size(); }

  /// C_ij = T(i−j), and T(i+j) besides for the mirror image of a one-sided node j > 0.
  double coefficient(Eigen::Index i, Eigen::Index j) const {
    const double own = influence_[std::abs(i - j)];
    return is_one_sided_ && j > 0 ? own + influence_[i + j] : own;
  }

  const Eigen::VectorXd& initial_gap() const { return initial_gap_; }  ///< h − least_gap()
  double least_gap() const { return least_gap_; }                      ///< of h at the nodes
  const Eigen::VectorXd& weights() const { return weights_; }          ///< w
  double total() const { return total_; }                              ///< 2P/(πE*)

  /// What rounding leaves of a gap in contact, whose terms are of the order of Σφ times the
  /// greatest T. The gaps far outside may be of any size: they are greater than their rounding.
  double rounding_of_gap() const;

 private:
  bool is_one_sided_;
  Eigen::VectorXd influence_;  // T(0), T(1), …
  Eigen::VectorXd initial_gap_;
  double least_gap_;
  Eigen::VectorXd weights_;
  double total_;
};

}  // namespace line_contact
