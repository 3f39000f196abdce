// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <memory>
#include <vector>

#include "block/factorization.hpp"
#include "block/lobatto_basis.hpp"

BOOST_AUTO_TEST_SUITE(manufactured_solution_test)

namespace {

const elasticity::Material material(3.7, 0.29);
const block::Lame constants = block::lame(material);

// u_x = sin(a) cos(b), u_z = cos(c) sin(d), a = 1.3x + 0.2, b = 1.7z + 0.4, c = 0.9x − 0.3, d =
// 1.1z + 0.5.
Eigen::Vector2d exact(double x, double z) {
  return {std::sin(1.3 * x + 0.2) * std::cos(1.7 * z + 0.4),
          std::cos(0.9 * x - 0.3) * std::sin(1.1 * z + 0.5)};
}

block::Stress exact_stress(double x, double z) {
  const double a = 1.3 * x + 0.2, b = 1.7 * z + 0.4, c = 0.9 * x - 0.3, d = 1.1 * z + 0.5;
  const block::Strain strain{1.3 * std::cos(a) * std::cos(b), 1.1 * std::cos(c) * std::cos(d),
                             -1.7 * std::sin(a) * std::sin(b) - 0.9 * std::sin(c) * std::sin(d)};
  return block::stress(constants, strain);
}

// −div σ = −[(λ+2μ) u_x,xx + μ u_x,zz + (λ+μ) u_z,xz], and alike along z.
Eigen::Vector2d body_force(double x, double z) {
  const auto [lambda, mu] = constants;
  const double a = 1.3 * x + 0.2, b = 1.7 * z + 0.4, c = 0.9 * x - 0.3, d = 1.1 * z + 0.5;
  const double ux = std::sin(a) * std::cos(b);
  const double uz = std::cos(c) * std::sin(d);
  const double ux_xz = -1.3 * 1.7 * std::cos(a) * std::sin(b);
  const double uz_xz = -0.9 * 1.1 * std::sin(c) * std::cos(d);
  return {((lambda + 2 * mu) * 1.3 * 1.3 + mu * 1.7 * 1.7) * ux - (lambda + mu) * uz_xz,
          ((lambda + 2 * mu) * 1.1 * 1.1 + mu * 0.9 * 0.9) * uz - (lambda + mu) * ux_xz};
}

std::vector<double> even_lines(double begin, double end, int n) {
  std::vector<double> lines;
  for (int i = 0; i <= n; ++i) lines.push_back(begin + (end - begin) * i / n);
  return lines;
}

// The displacement prescribed on three sides, tractions on the top, body forces inside.
block::Solution solve(int order, int n) {
  const auto model = std::make_shared<const block::Model>(
      block::Mesh(order, even_lines(-1, 1.2, 2 * n), even_lines(0, 1.1, n)), material);
  const auto load =
      elasticity::distributed_load([](double x) { return -exact_stress(x, 0).zz; },
                                   [](double x) { return -exact_stress(x, 0).xz; }, {-1, 1.2});
  const block::Factorization factorization(model, block::with_sides(block::Support::clamped));
  return factorization.solve(
      {.surface = load, .body_force = body_force, .prescribed_displacement = exact});
}

// √∫|u − u_exact|² dx dz.
double l2_error(const block::Solution& solution) {
  const block::LegendreRule rule = block::gauss_rule(solution.model().mesh().order() + 4);
  const Eigen::Index n = rule.points.size();
  double sum = 0;
  for (block::Index index = 0; index < solution.model().mesh().n_elements(); ++index) {
    const block::Element e = solution.model().mesh().element(index);
    const auto states = solution.sample(index, rule.points);
    for (Eigen::Index k = 0; k < n * n; ++k) {
      const auto& state = states[static_cast<std::size_t>(k)];
      const double weight = rule.weights[k % n] * rule.weights[k / n] * e.width() * e.height() / 4;
      sum += weight *
             (state.displacement - exact(state.position.x(), state.position.y())).squaredNorm();
    }
  }
  return std::sqrt(sum);
}

}  // namespace

BOOST_AUTO_TEST_CASE(l2_error_falls_with_rate_p_plus_1) {
  for (int order = 1; order <= 6; ++order) {
    const int n = order < 4 ? 6 : 3;

    const double rate = std::log2(l2_error(solve(order, n)) / l2_error(solve(order, 2 * n)));

    BOOST_TEST_CONTEXT("order " << order) {
      BOOST_TEST(rate > order + 1 - 0.15);
      BOOST_TEST(rate < order + 1 + 0.35);
    }
  }
}

BOOST_AUTO_TEST_CASE(error_falls_exponentially_with_the_order) {
  double last = l2_error(solve(2, 2));
  for (int order = 3; order <= 9; ++order) {
    const double error = l2_error(solve(order, 2));

    BOOST_TEST(error < last / 5);
    last = error;
  }
  BOOST_TEST(last < 1e-10);
}

BOOST_AUTO_TEST_CASE(stresses_are_those_of_the_manufactured_solution) {
  const block::Solution solution = solve(9, 2);

  for (const double x : {-0.7385, 0.113, 1.05}) {
    for (const double z : {0.0, 0.4185, 1.0}) {
      const block::Stress computed = solution.at(x, z).stress;
      const block::Stress expected = exact_stress(x, z);
      BOOST_TEST(std::abs(computed.xx - expected.xx) < 1e-7);
      BOOST_TEST(std::abs(computed.zz - expected.zz) < 1e-7);
      BOOST_TEST(std::abs(computed.xz - expected.xz) < 1e-7);
      BOOST_TEST(std::abs(computed.yy - 0.29 * (expected.xx + expected.zz)) < 1e-7);
    }
  }
}

BOOST_AUTO_TEST_CASE(body_forces_and_tractions_are_carried_by_the_supports) {
  const block::Solution solution = solve(4, 3);

  const block::Resultant sum = solution.applied();
  const block::Resultant reactions = solution.reactions();

  BOOST_TEST((sum.force + reactions.force).norm() < 1e-10 * sum.force.norm());
  BOOST_TEST(std::abs(sum.moment + reactions.moment) < 1e-10 * sum.force.norm());
}

BOOST_AUTO_TEST_SUITE_END()
