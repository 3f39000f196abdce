// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/element.hpp"

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

Lame lame(const elasticity::Material& material) {
  const double nu = material.poisson();
  const double mu = material.young() / (2 * (1 + nu));
  return {2 * mu * nu / (1 - 2 * nu), mu};
}

Eigen::MatrixXd element_stiffness(const LobattoBasis::Integrals& integrals, const Lame& lame,
                                  double aspect) {
  const auto& [mass, stiffness, slope] = integrals;
  const Eigen::Index n = mass.rows();
  Eigen::MatrixXd k(2 * n * n, 2 * n * n);
  for (Eigen::Index l = 0; l < n; ++l) {
    for (Eigen::Index j = 0; j < n; ++j) {
      // Couple the nodes of row j with those of row l, all steps i along x with all steps m
      const auto along_x = stiffness * (mass(j, l) * aspect);  // ∫ ∂N/∂x ∂N/∂x
      const auto along_z = mass * (stiffness(j, l) / aspect);  // ∫ ∂N/∂z ∂N/∂z
      const auto x_then_z = slope * slope(l, j);               // ∫ ∂N/∂x ∂N/∂z
      const auto z_then_x = slope.transpose() * slope(j, l);   // ∫ ∂N/∂z ∂N/∂x
      const double p_modulus = lame.lambda + 2 * lame.mu;
      const auto block = [&](int row, int column) {
        return k(Eigen::seqN(2 * j * n + row, n, 2), Eigen::seqN(2 * l * n + column, n, 2));
      };
      block(0, 0) = p_modulus * along_x + lame.mu * along_z;
      block(1, 1) = p_modulus * along_z + lame.mu * along_x;
      block(0, 1) = lame.lambda * x_then_z + lame.mu * z_then_x;
      block(1, 0) = lame.lambda * z_then_x + lame.mu * x_then_z;
    }
  }
  return k;
}

StackedIntegrals::StackedIntegrals(const LobattoBasis::Integrals& integrals) {
  const auto& [mass, stiffness, slope] = integrals;
  const Eigen::Index n = mass.rows();
  along_x.resize(4 * n, n);
  along_z.resize(4 * n, n);
  along_x << stiffness, mass, slope, slope.transpose();
  along_z << mass, stiffness, slope, slope.transpose();
}

Eigen::MatrixXd element_forces(const StackedIntegrals& integrals, const Lame& lame, double aspect,
                               const Eigen::MatrixXd& u) {
  const Eigen::Index n = u.rows();
  const double p_modulus = lame.lambda + 2 * lame.mu;
  const Eigen::MatrixXd along_x = integrals.along_x * u;
  const auto part = [&](int integral, int component) {
    return along_x.block(integral * n, component * n, n, n);
  };
  Eigen::MatrixXd sides(2 * n, 4 * n);
  sides << p_modulus * aspect * part(0, 0), lame.mu / aspect * part(1, 0), lame.lambda * part(2, 1),
      lame.mu * part(3, 1),  //
      lame.mu * aspect * part(0, 1), p_modulus / aspect * part(1, 1), lame.mu * part(2, 0),
      lame.lambda * part(3, 0);
  const Eigen::MatrixXd forces = sides * integrals.along_z;
  Eigen::MatrixXd result(n, 2 * n);
  result << forces.topRows(n), forces.bottomRows(n);
  return result;
}

UnknownSplit split_unknowns(int order) {
  UnknownSplit split;
  for (int j = 0; j <= order; ++j) {
    for (int i = 0; i <= order; ++i) {
      const bool inside = i > 0 && i < order && j > 0 && j < order;
      std::vector<int>& part = inside ? split.interior : split.edge;
      for (int c = 0; c < 2; ++c) part.push_back(2 * (j * (order + 1) + i) + c);
    }
  }
  return split;
}

CondensedStiffness condense(const Eigen::MatrixXd& stiffness, const UnknownSplit& split) {
  CondensedStiffness result;
  result.edge = stiffness(split.edge, split.edge);                         // K_ee
  const Eigen::MatrixXd coupling = stiffness(split.interior, split.edge);  // K_ie
  result.interior.compute(stiffness(split.interior, split.interior));
  if (result.interior.info() != Eigen::Success) {
    throw FactorizationError("the interior stiffness of an element is not positive definite");
  }
  result.recovery = result.interior.solve(coupling);                // R = K_ii⁻¹ K_ie
  result.edge.noalias() -= coupling.transpose() * result.recovery;  // K_ee − K_ei R
  return result;
}

}  // namespace block
