// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace block {

/// Points in [−1, 1] and the weights of a quadrature ∫ f dξ ≈ Σ wᵢ f(ξᵢ).
struct LegendreRule {
  Eigen::VectorXd points;   ///< rising
  Eigen::VectorXd weights;  ///< sum 2
};

/// The Gauss–Legendre rule of n ≥ 1 points, exact for polynomials of degree 2n − 1.
///
/// Points are the roots of P_n by Newton's method, weights 2/[(1 − ξ²) P_n′(ξ)²]; 1e-15 absolute
/// for n up to 100.
LegendreRule gauss_rule(int n);

/// The Gauss–Lobatto–Legendre rule of n ≥ 2 points, ±1 among them, exact for degree 2n − 3.
///
/// Inner points are the roots of P_{n−1}′, weights 2/[n(n − 1) P_{n−1}(ξ)²]; accuracy as above.
LegendreRule lobatto_rule(int n);

}  // namespace block
