// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/lobatto_basis.hpp"

#include <gsl/gsl_integration.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>

namespace block {
namespace {

// The roots of (1 − ξ²) P_p′(ξ) = p (P_{p−1} − ξ P_p), whose derivative is −p (p + 1) P_p. Newton's
// method doubles the number of correct digits in each step; from a cosine as the first guess, eight
// steps reach rounding.
Eigen::VectorXd lobatto_points(int p) {
  Eigen::VectorXd points(p + 1);
  for (int i = 0; i <= p; ++i) {
    double xi = -std::cos(std::numbers::pi * i / p);
    for (int step = 0; step < 8; ++step) {
      double legendre = 1;
      double previous = 0;
      for (int k = 1; k <= p; ++k) {
        const double next = ((2 * k - 1) * xi * legendre - (k - 1) * previous) / k;
        previous = legendre;
        legendre = next;
      }
      xi -= (xi * legendre - previous) / ((p + 1) * legendre);
    }
    points[i] = xi;
  }
  return points;
}

}  // namespace

GaussRule gauss_rule(int n) {
  const std::unique_ptr<gsl_integration_glfixed_table, void (*)(gsl_integration_glfixed_table*)>
      table(gsl_integration_glfixed_table_alloc(static_cast<std::size_t>(n)),
            &gsl_integration_glfixed_table_free);
  GaussRule rule{Eigen::VectorXd(n), Eigen::VectorXd(n)};
  for (int i = 0; i < n; ++i) {
    gsl_integration_glfixed_point(-1, 1, static_cast<std::size_t>(i), &rule.points[i],
                                  &rule.weights[i], table.get());
  }
  return rule;
}

LobattoBasis::LobattoBasis(int order) : nodes_(lobatto_points(order)) {
  const Eigen::Index n = nodes_.size();
  barycentric_weights_ = Eigen::VectorXd::Ones(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      if (j != i) barycentric_weights_[i] /= nodes_[i] - nodes_[j];
    }
  }

  // Each row sums to zero, because the derivative of a constant vanishes.
  nodal_derivatives_ = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      if (j == i) continue;
      nodal_derivatives_(i, j) =
          barycentric_weights_[j] / barycentric_weights_[i] / (nodes_[i] - nodes_[j]);
      nodal_derivatives_(i, i) -= nodal_derivatives_(i, j);
    }
  }
}

Eigen::VectorXd LobattoBasis::values(double xi) const {
  Eigen::VectorXd terms(nodes_.size());
  for (Eigen::Index i = 0; i < nodes_.size(); ++i) {
    if (xi == nodes_[i]) return Eigen::VectorXd::Unit(nodes_.size(), i);
    terms[i] = barycentric_weights_[i] / (xi - nodes_[i]);
  }
  return terms / terms.sum();
}

Eigen::MatrixXd LobattoBasis::values_at(const Eigen::VectorXd& points) const {
  Eigen::MatrixXd result(points.size(), nodes_.size());
  for (Eigen::Index k = 0; k < points.size(); ++k) result.row(k) = values(points[k]);
  return result;
}

Eigen::MatrixXd LobattoBasis::derivatives_at(const Eigen::VectorXd& points) const {
  return values_at(points) * nodal_derivatives_;
}

LobattoBasis::Integrals LobattoBasis::integrals() const {
  const GaussRule rule = gauss_rule(order() + 1);
  const Eigen::MatrixXd n = values_at(rule.points);
  const Eigen::MatrixXd dn = derivatives_at(rule.points);
  const auto weights = rule.weights.asDiagonal();
  return {n.transpose() * weights * n, dn.transpose() * weights * dn, dn.transpose() * weights * n};
}

}  // namespace block
