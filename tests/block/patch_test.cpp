// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <memory>

#include "block/factorization.hpp"
#include "elasticity/load_shapes.hpp"

BOOST_AUTO_TEST_SUITE(patch_test)

namespace {

constexpr int max_order = 10;
// Rounding times the condition of elements up to 60 times as long as high.
constexpr double round_off = 1e-11;

std::shared_ptr<const block::Model> irregular_model(int order) {
  return std::make_shared<const block::Model>(
      block::Mesh(order, {-1, -0.31, 0.02, 0.07, 1.3}, {0, 0.02, 0.33, 1.1}),
      elasticity::Material(2.385e5, 0.317));
}

block::Supports all_clamped() {
  const auto clamped = block::Support::clamped;
  return {.left = clamped, .right = clamped, .bottom = clamped, .top = clamped};
}

}  // namespace

BOOST_AUTO_TEST_CASE(linear_displacement_on_the_boundary_strains_the_inside_evenly) {
  const auto linear = [](double x, double z) {
    return Eigen::Vector2d(1e-3 + 2.1e-3 * x - 0.7e-3 * z, -2e-3 + 1.3e-3 * x + 0.4e-3 * z);
  };
  for (int order = 1; order <= max_order; ++order) {
    const block::Factorization factorization(irregular_model(order), all_clamped());

    const block::Solution solution = factorization.solve({.prescribed_displacement = linear});

    for (block::Index e = 0; e < solution.model().mesh().n_elements(); ++e) {
      for (const auto& state : solution.sample(e, Eigen::VectorXd::LinSpaced(5, -1, 1))) {
        const Eigen::Vector2d exact = linear(state.position.x(), state.position.y());
        BOOST_TEST((state.displacement - exact).norm() < round_off * 1e-3);
        BOOST_TEST(std::abs(state.strain.xx - 2.1e-3) < round_off * 1e-1);
        BOOST_TEST(std::abs(state.strain.zz - 0.4e-3) < round_off * 1e-1);
        BOOST_TEST(std::abs(state.strain.gamma - 0.6e-3) < round_off * 1e-1);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(even_pressure_between_rollers_strains_along_z_only) {
  const double young = 2.385e5;
  const double nu = 0.317;
  const double pressure = 71.5;
  const auto load =
      elasticity::distributed_load([=](double) { return pressure; }, nullptr, {-1, 1.3});
  for (int order = 2; order <= max_order; ++order) {
    const block::Factorization factorization(irregular_model(order),
                                             block::with_sides(block::Support::roller));

    const block::Solution solution = factorization.solve(load);

    const double strain = pressure * (1 - 2 * nu) * (1 + nu) / ((1 - nu) * young);
    const double side = -pressure * nu / (1 - nu);
    for (const double x : {-0.9, 0.033, 1.2}) {
      for (const double z : {0.0, 0.017, 0.6}) {
        const block::PointState state = solution.at(x, z);
        BOOST_TEST(state.displacement.y() == strain * (1.1 - z),
                   boost::test_tools::tolerance(round_off));
        BOOST_TEST(state.stress.zz == -pressure, boost::test_tools::tolerance(100 * round_off));
        BOOST_TEST(state.stress.xx == side, boost::test_tools::tolerance(100 * round_off));
        BOOST_TEST(state.stress.yy == side, boost::test_tools::tolerance(100 * round_off));
        BOOST_TEST(std::abs(state.stress.xz) < 100 * round_off * pressure);
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
