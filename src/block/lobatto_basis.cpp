// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/lobatto_basis.hpp"

namespace block {

LobattoBasis::LobattoBasis(int order) : nodes_(lobatto_rule(order + 1).points) {
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
  const LegendreRule rule = gauss_rule(order() + 1);
  const Eigen::MatrixXd n = values_at(rule.points);
  const Eigen::MatrixXd dn = derivatives_at(rule.points);
  const auto weights = rule.weights.asDiagonal();
  return {n.transpose() * weights * n, dn.transpose() * weights * dn, dn.transpose() * weights * n};
}

}  // namespace block
