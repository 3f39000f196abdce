// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/mesh.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "block/element.hpp"
#include "elasticity/loads.hpp"

BOOST_AUTO_TEST_SUITE(mesh_test)

BOOST_AUTO_TEST_CASE(graded_lines_reach_the_smallest_size_and_grow_by_the_ratio_at_most) {
  const auto lines = block::graded_lines({{-1, 0.2}, {0.1, 0.003}, {0.7, 0.05}}, 0.3);

  BOOST_TEST(lines.front() == -1.0);
  BOOST_TEST(lines.back() == 0.7);
  BOOST_TEST(std::is_sorted(lines.begin(), lines.end()));
  const auto kink = std::find(lines.begin(), lines.end(), 0.1);
  BOOST_REQUIRE(kink != lines.end());
  BOOST_TEST(*(kink + 1) - 0.1 == 0.003, boost::test_tools::tolerance(1e-10));
  BOOST_TEST(0.1 - *(kink - 1) == 0.003, boost::test_tools::tolerance(1e-10));
  for (auto line = kink + 1; *(line + 1) < 0.4; ++line) {
    BOOST_TEST((*(line + 1) - 0.1) / (*line - 0.1) <= 1 / 0.3 + 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(every_kink_of_every_load_is_exactly_one_line_of_the_mesh) {
  const auto flat =
      elasticity::distributed_load([](double) { return 3.0; }, {-0.1, -0.06, 0.06, 0.1});
  const auto wider = elasticity::LinearFall(3, 0, std::nextafter(0.1, 1));
  const auto whole = elasticity::LinearFall(3, 0, std::nextafter(1.0, 0));

  BOOST_TEST(block::kinks_of({flat, wider}).size() == 5U);
  block::Index last = 0;
  for (int refine = 1; refine <= 4; ++refine) {
    const auto mesh = block::graded_mesh({2, 1}, {flat, wider, whole}, {4, refine});
    const std::vector<double>& lines = mesh.x_lines();
    for (const double kink : {-1.0, -0.1, -0.06, 0.0, 0.06, 0.1, 1.0}) {
      const auto is_there = [kink](double line) { return std::abs(line - kink) < 1e-15; };
      BOOST_TEST(std::count_if(lines.begin(), lines.end(), is_there) == 1);
    }
    for (std::size_t i = 1; i < lines.size(); ++i) BOOST_TEST(lines[i] - lines[i - 1] > 1e-5);
    BOOST_TEST(mesh.n_elements() > last);
    last = mesh.n_elements();
  }
}

BOOST_AUTO_TEST_CASE(rules_and_basis_are_exact_for_polynomials) {
  const auto power = [](double x, int n) { return n == 0 ? 1 : std::pow(x, n); };
  for (int order = 1; order <= 12; ++order) {
    const block::GaussRule rule = block::gauss_rule(order);
    for (int degree = 0; degree <= 2 * order - 1; ++degree) {
      double sum = 0;
      for (int i = 0; i < order; ++i) sum += rule.weights[i] * power(rule.points[i], degree);
      BOOST_TEST(std::abs(sum - (degree % 2 == 0 ? 2.0 / (degree + 1) : 0)) < 1e-13);
    }

    const block::LobattoBasis basis(order);
    BOOST_TEST(basis.nodes()[0] == -1);
    BOOST_TEST(basis.nodes()[order] == 1);
    const Eigen::VectorXd nodal =
        basis.nodes().unaryExpr([&](double x) { return power(x, order); });
    for (const double xi : {-1.0, -0.7317, 0.0, 0.2385, 1.0}) {
      BOOST_TEST(std::abs(basis.values(xi).dot(nodal) - power(xi, order)) < 1e-13);
      const auto derivatives = basis.derivatives_at(Eigen::VectorXd::Constant(1, xi));
      BOOST_TEST(std::abs(derivatives.row(0).dot(nodal) - order * power(xi, order - 1)) < 1e-11);
    }

    // ∫ (N_i N_j)′ dξ is N_i N_j at the ends, and Lobatto's rule has 2/(p(p + 1)) there
    const auto [mass, stiffness, slope] = basis.integrals();
    Eigen::MatrixXd ends = Eigen::MatrixXd::Zero(order + 1, order + 1);
    ends(0, 0) = -1;
    ends(order, order) = 1;
    BOOST_TEST((slope + slope.transpose() - ends).cwiseAbs().maxCoeff() < 1e-13);
    BOOST_TEST(std::abs(mass.row(0).sum() - 2.0 / (order * (order + 1))) < 1e-13);
    BOOST_TEST(stiffness.rowwise().sum().cwiseAbs().maxCoeff() < 1e-11);
  }
}

BOOST_AUTO_TEST_SUITE_END()
