// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/solution.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "block/paper_block.hpp"
#include "system/require.hpp"

BOOST_AUTO_TEST_SUITE(solution_test)

BOOST_AUTO_TEST_SUITE(stress)

BOOST_AUTO_TEST_CASE(out_of_plane_stress_is_poisson_times_the_sum_of_the_others) {
  const elasticity::Material material(2.1e5, 0.27);

  const block::Stress s = block::stress(block::lame(material), {1.3e-3, -0.8e-3, 0.5e-3});

  BOOST_CHECK_CLOSE(s.yy, 0.27 * (s.xx + s.zz), 1e-10);
  BOOST_CHECK_CLOSE(s.xz, 2.1e5 / (2 * 1.27) * 0.5e-3, 1e-10);
  // ε_yy = 0 = [σ_yy − ν(σ_xx + σ_zz)]/E, and ε_xx by the inverse law
  BOOST_CHECK_CLOSE((s.xx - 0.27 * (s.zz + s.yy)) / 2.1e5, 1.3e-3, 1e-10);
}

BOOST_AUTO_TEST_CASE(principal_stresses_are_those_of_mohrs_circle) {
  const auto principal = block::principal_stresses({50, -30, 30, 70});

  BOOST_CHECK_CLOSE(principal[0], 70.0, 1e-10);
  BOOST_CHECK_CLOSE(principal[1], 60.0, 1e-10);
  BOOST_CHECK_CLOSE(principal[2], -40.0, 1e-10);
}

BOOST_AUTO_TEST_CASE(von_mises_is_the_tension_of_a_bar_and_root_three_times_a_shear) {
  BOOST_CHECK_CLOSE(block::von_mises({123, 0, 0, 0}), 123.0, 1e-10);
  BOOST_CHECK_CLOSE(block::von_mises({0, 0, 10, 0}), 17.320508075688773, 1e-10);
  BOOST_TEST(block::von_mises({7, 7, 0, 7}) == 0);
}

BOOST_AUTO_TEST_SUITE_END()

using block::Support;

namespace {

block::Solution solve(const elasticity::Load& load, Support sides) {
  const block::Analysis analysis(paper_block::rectangle, paper_block::material, {load},
                                 {.order = 6, .refine = 1});
  return analysis.on(block::with_sides(sides)).fine().solve(load);
}

const elasticity::Load skew_load =
    elasticity::distributed_load([](double x) { return 300 + 2e4 * x * x * x; },
                                 [](double x) { return 50 - 900 * x; }, {-0.31, 0.07, 0.585});

}  // namespace

BOOST_AUTO_TEST_CASE(reactions_balance_any_load) {
  for (const Support sides : {Support::clamped, Support::roller, Support::free}) {
    for (const auto& load : {skew_load, elasticity::LinearFall(1000, 0.6, 0.01)}) {
      const block::Solution solution = solve(load, sides);

      const block::Resultant applied = solution.applied();
      const block::Resultant reactions = solution.reactions();

      const double scale = applied.force.norm();
      BOOST_TEST((applied.force + reactions.force).norm() < 1e-10 * scale);
      BOOST_TEST(std::abs(applied.moment + reactions.moment) < 1e-10 * scale);
    }
  }
}

BOOST_AUTO_TEST_CASE(resultant_is_the_integral_of_the_tractions) {
  const block::Resultant applied = solve(skew_load, Support::clamped).applied();

  // ∫ p, ∫ q and −∫ x p over [−0.31, 0.585], integrated by hand: 300x + 5e3 x⁴, 50x − 450x² and
  // 150x² + 4e3 x⁵.
  const auto between = [](auto f) { return f(0.585) - f(-0.31); };
  const double p = between([](double x) { return 300 * x + 5e3 * std::pow(x, 4); });
  const double q = between([](double x) { return 50 * x - 450 * x * x; });
  const double moment = between([](double x) { return 150 * x * x + 4e3 * std::pow(x, 5); });
  BOOST_TEST(applied.force.x() == q, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(applied.force.y() == p, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(applied.moment == -moment, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(symmetric_load_displaces_symmetrically) {
  for (const Support sides : {Support::clamped, Support::roller, Support::free}) {
    const block::Solution solution = solve(elasticity::LinearFall(1000, 0.6, 0.01), sides);

    for (const double x : {0.00385, 0.01, 0.0317, 0.6}) {
      for (const double z : {0.0, 0.0077, 0.4}) {
        const block::PointState right = solution.at(x, z);
        const block::PointState left = solution.at(-x, z);
        BOOST_TEST(std::abs(right.displacement.y() - left.displacement.y()) < 1e-15);
        BOOST_TEST(std::abs(right.displacement.x() + left.displacement.x()) < 1e-15);
      }
    }
    BOOST_TEST(std::abs(solution.displacement(0, 0).x()) < 1e-16);
  }
}

BOOST_AUTO_TEST_CASE(strain_energy_is_half_the_work_of_the_load) {
  for (const Support sides : {Support::clamped, Support::roller, Support::free}) {
    const elasticity::Load load = elasticity::LinearFall(1000, 0, 0.01);
    const block::Solution solution = solve(load, sides);

    // ½∫ p u_z dx by Simpson's rule on each half of the triangle
    double work = 0;
    constexpr int n = 400;
    for (int i = 0; i <= n; ++i) {
      const double x = 0.01 * i / n;
      const double weight = (i == 0 || i == n ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) / 3 * 0.01 / n;
      work += weight * 1000 * (1 - x / 0.01) * solution.displacement(x, 0).y();
    }
    BOOST_TEST(solution.strain_energy() == work, boost::test_tools::tolerance(1e-7));
  }
}

BOOST_AUTO_TEST_CASE(results_do_not_depend_on_the_system_of_units) {
  const double inch = 25.4;           // mm
  const double psi = 6.894757293e-3;  // MPa
  const auto load = elasticity::LinearFall(1000, 0.6, 0.01);
  const auto metric_load = elasticity::LinearFall(1000 * psi, 0.6, 0.01 * inch);
  const block::Analysis metric({2 * inch, inch}, {30e6 * psi, 0.3}, {metric_load},
                               {.order = 6, .refine = 1});

  const block::Solution us = solve(load, Support::clamped);
  const block::Solution si =
      metric.on(block::with_sides(Support::clamped)).fine().solve(metric_load);

  for (const double x : {0.0, 0.0137, 0.05, 0.9}) {
    BOOST_TEST(si.displacement(x * inch, 0.002 * inch).y() == inch * us.displacement(x, 0.002).y(),
               boost::test_tools::tolerance(1e-10));
  }
  BOOST_TEST(si.strain_energy() == inch * inch * psi * us.strain_energy(),
             boost::test_tools::tolerance(1e-10));
}

BOOST_AUTO_TEST_CASE(combination_is_the_solution_of_the_combined_load) {
  const auto triangle = elasticity::LinearFall(1, 0, 0.01);
  const auto uniform = elasticity::LinearFall(1, 1, 0.01);
  const block::Analysis analysis(paper_block::rectangle, paper_block::material, {triangle, uniform},
                                 {.order = 4, .refine = 0});
  const auto clamped = analysis.on(block::with_sides(Support::clamped));

  const auto sum = block::RefinedSolution::combination(
      {clamped.solve(triangle), clamped.solve(uniform)}, {400, 600});
  const auto direct = clamped.solve(elasticity::LinearFall(1000, 0.6, 0.01));

  const numerics::Estimate expected = direct.displacement_z(0.02, 0);
  BOOST_TEST(sum.displacement_z(0.02, 0).value == expected.value,
             boost::test_tools::tolerance(1e-11));
  BOOST_TEST(sum.fine().reactions().force.y() == -16, boost::test_tools::tolerance(1e-10));
}

BOOST_AUTO_TEST_CASE(estimates_are_the_finer_value_and_its_distance_from_the_coarser) {
  const block::Analysis analysis(paper_block::rectangle, paper_block::material, {skew_load},
                                 {.order = 3, .refine = 0});

  const auto solution = analysis.on(block::with_sides(Support::roller)).solve(skew_load);

  const double fine = solution.fine().displacement(0.1, 0.2).y();
  const double difference = fine - solution.coarse().displacement(0.1, 0.2).y();
  BOOST_TEST(solution.displacement_z(0.1, 0.2).value == fine);
  BOOST_TEST(solution.displacement_z(0.1, 0.2).abs_error == std::abs(difference));
  BOOST_TEST(std::abs(difference) > 0);
}

BOOST_AUTO_TEST_CASE(points_outside_the_block_are_refused) {
  const block::Solution solution =
      solve(elasticity::LinearFall(1000, 0.6, 0.01), Support::clamped);

  BOOST_CHECK_THROW(solution.displacement(1.001, 0), sys::InvalidQuantity);
  BOOST_CHECK_THROW(solution.at(0, 1.001), sys::InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
