// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace block {

/// Points in [−1, 1] and the weights of a quadrature ∫ f dξ ≈ Σ wᵢ f(ξᵢ).
struct GaussRule {
  Eigen::VectorXd points;
  Eigen::VectorXd weights;
};

/// The Gauss–Legendre rule of n ≥ 1 points, exact for polynomials of degree 2n − 1.
GaussRule gauss_rule(int n);

/// Lagrange polynomials N₀ … N_p on [−1, 1] through the p + 1 Gauss–Lobatto points: ±1 and the
/// interior extremes of Legendre's polynomial P_p.
///
/// These nodes keep the basis well conditioned for every order used here, and the end nodes make
/// neighbouring elements conform. All members are accurate to about 1e-15·p².
class LobattoBasis {
 public:
  /// order p ≥ 1.
  explicit LobattoBasis(int order);

  int order() const { return static_cast<int>(nodes_.size()) - 1; }
  const Eigen::VectorXd& nodes() const { return nodes_; }

  /// N_i(ξ), i = 0 … p, by the barycentric formula.
  Eigen::VectorXd values(double xi) const;

  /// N_i(ξ_k) as a matrix of points × (p + 1), and dN_i/dξ(ξ_k) likewise; the derivatives are exact
  /// because its nodal values determine each polynomial N_i.
  Eigen::MatrixXd values_at(const Eigen::VectorXd& points) const;
  Eigen::MatrixXd derivatives_at(const Eigen::VectorXd& points) const;

  /// The integrals that make up every rectangular element, each (p + 1) × (p + 1), exact.
  struct Integrals {
    Eigen::MatrixXd mass;       ///< ∫ N_i N_j dξ
    Eigen::MatrixXd stiffness;  ///< ∫ N_i′ N_j′ dξ
    Eigen::MatrixXd slope;      ///< ∫ N_i′ N_j dξ
  };
  Integrals integrals() const;

 private:
  Eigen::VectorXd nodes_;
  Eigen::VectorXd barycentric_weights_;
  Eigen::MatrixXd nodal_derivatives_;  // dN_j/dξ at node i
};

}  // namespace block
