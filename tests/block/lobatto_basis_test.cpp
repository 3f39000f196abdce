// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/lobatto_basis.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

BOOST_AUTO_TEST_SUITE(lobatto_basis_test)

namespace {

constexpr double rounding = 1e-13;

double power(double x, int n) {
  return n == 0 ? 1 : std::pow(x, n);
}

double integral_of_power(int n) {
  return n % 2 == 0 ? 2.0 / (n + 1) : 0;
}

}  // namespace

BOOST_AUTO_TEST_CASE(gauss_rule_is_exact_to_degree_2n_minus_1) {
  for (int n = 1; n <= 30; ++n) {
    const block::LegendreRule rule = block::gauss_rule(n);

    for (int degree = 0; degree <= 2 * n - 1; ++degree) {
      double sum = 0;
      for (int i = 0; i < n; ++i) sum += rule.weights[i] * power(rule.points[i], degree);
      BOOST_TEST(std::abs(sum - integral_of_power(degree)) < rounding);
    }
  }
}

BOOST_AUTO_TEST_CASE(lobatto_rule_is_exact_to_degree_2n_minus_3_and_holds_both_ends) {
  for (int n = 2; n <= 13; ++n) {
    const block::LegendreRule rule = block::lobatto_rule(n);

    BOOST_TEST(rule.points[0] == -1.0);
    BOOST_TEST(rule.points[n - 1] == 1.0);
    for (int degree = 0; degree <= 2 * n - 3; ++degree) {
      double sum = 0;
      for (int i = 0; i < n; ++i) sum += rule.weights[i] * power(rule.points[i], degree);
      BOOST_TEST(std::abs(sum - integral_of_power(degree)) < rounding);
    }
  }
}

BOOST_AUTO_TEST_CASE(basis_reproduces_polynomials_and_their_derivatives) {
  for (int order = 1; order <= 12; ++order) {
    const block::LobattoBasis basis(order);
    const Eigen::VectorXd nodal =
        basis.nodes().unaryExpr([&](double x) { return power(x, order); });

    for (const double xi : {-1.0, -0.7317, 0.0, 0.2385, 1.0}) {
      BOOST_TEST(std::abs(basis.values(xi).dot(nodal) - power(xi, order)) < rounding);
      const double slope = order * power(xi, order - 1);
      BOOST_TEST(std::abs(basis.derivatives_at(Eigen::VectorXd::Constant(1, xi)).row(0).dot(nodal) -
                          slope) < 100 * rounding);
    }
  }
}

BOOST_AUTO_TEST_CASE(integrals_integrate_by_parts) {
  for (int order = 1; order <= 10; ++order) {
    const auto [mass, stiffness, slope] = block::LobattoBasis(order).integrals();

    // ∫ (N_i N_j)′ dξ is N_i N_j at the ends
    Eigen::MatrixXd ends = Eigen::MatrixXd::Zero(order + 1, order + 1);
    ends(0, 0) = -1;
    ends(order, order) = 1;
    BOOST_TEST((slope + slope.transpose() - ends).cwiseAbs().maxCoeff() < rounding);
    BOOST_TEST(std::abs(mass.sum() - 2) < rounding);
    BOOST_TEST(stiffness.rowwise().sum().cwiseAbs().maxCoeff() < 100 * rounding);
  }
}

BOOST_AUTO_TEST_SUITE_END()
