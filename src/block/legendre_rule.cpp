// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/lobatto_basis.hpp"

#include <cmath>
#include <numbers>

namespace block {
namespace {

// Returns P_n(ξ) and P_{n−1}(ξ), which the three-term recurrence gives.
struct LegendrePair {
  double current;
  double previous;
};

LegendrePair legendre(int n, double xi) {
  LegendrePair p{1, 0};
  for (int k = 1; k <= n; ++k) {
    const double next = ((2 * k - 1) * xi * p.current - (k - 1) * p.previous) / k;
    p = {next, p.current};
  }
  return p;
}

// Newton's method doubles the number of right digits in each step, so that eight steps reach
// rounding from the cosine that is the first guess.
template <class Step>
double newton(double xi, Step step) {
  for (int k = 0; k < 8; ++k) xi -= step(xi);
  return xi;
}

}  // namespace

LegendreRule gauss_rule(int n) {
  LegendreRule rule{Eigen::VectorXd(n), Eigen::VectorXd(n)};
  const auto slope = [n](double xi, const LegendrePair& p) {
    return n * (xi * p.current - p.previous) / (xi * xi - 1);
  };
  for (int i = 0; i < n; ++i) {
    const double guess = -std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
    const double xi = newton(guess, [&](double x) {
      const LegendrePair p = legendre(n, x);
      return p.current / slope(x, p);
    });
    const double derivative = slope(xi, legendre(n, xi));
    rule.points[i] = xi;
    rule.weights[i] = 2 / ((1 - xi * xi) * derivative * derivative);
  }
  return rule;
}

LegendreRule lobatto_rule(int n) {
  LegendreRule rule{Eigen::VectorXd(n), Eigen::VectorXd(n)};
  const int m = n - 1;
  for (int i = 0; i < n; ++i) {
    // (1 − ξ²) P_m′ = m (P_{m−1} − ξ P_m), and its derivative is −m (m + 1) P_m.
    const double xi = newton(-std::cos(std::numbers::pi * i / m), [m](double x) {
      const LegendrePair p = legendre(m, x);
      return (x * p.current - p.previous) / ((m + 1) * p.current);
    });
    const double value = legendre(m, xi).current;
    rule.points[i] = xi;
    rule.weights[i] = 2 / (m * n * value * value);
  }
  return rule;
}

}  // namespace block
