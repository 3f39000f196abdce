// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/dense_methods.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "line_contact/energy.hpp"
#include "random_inputs.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(variational_test)

using Eigen::Index;
using Eigen::VectorXd;
using line_contact::Element;
using line_contact::energy;
using line_contact::Grid;
using line_contact::grid_of_width;
using line_contact::one_sided_grid;
using line_contact::Problem;
using line_contact::Profile;
using line_contact::Solution;
using line_contact::solve_by_matrix_inversion;
using line_contact::solve_by_variational_method;
using sys::InvalidQuantity;
using tolerance::relative_difference;

namespace {

constexpr Element elements[] = {Element::point, Element::uniform, Element::triangular};
constexpr double load = 3.461;

Problem cylinders_on(const Grid& grid, Element element = Element::triangular) {
  return {Profile::parabola(0.571), 913.7, grid, element};
}

// 4·3.461/(π·913.7·0.571) = 0.0919²: a = 0.0919 of the domain's 0.12.
const Grid grid = grid_of_width(0.2385, 77);

// The same load in other pressures, all ≥ 0.
Solution disturbed(const Solution& solution, std::uint64_t seed, double size) {
  RandomInputs random(seed);
  Solution other = solution;
  const double total = solution.line_load();
  for (double& p : other.pressure) {
    p = std::max(0., p + size * solution.peak_pressure() * random.uniform(-1, 1));
  }
  other.pressure *= total / other.line_load();
  return other;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_pressures_are_those_of_matrix_inversion_to_1e_10_of_the_peak) {
  for (const Element element : elements) {
    for (const Grid& on : {grid, grid_of_width(0.24, 42), one_sided_grid(0.24, 41)}) {
      const Problem problem = cylinders_on(on, element);
      const Solution inverted = solve_by_matrix_inversion(problem, load);
      const Solution least = solve_by_variational_method(problem, load);

      BOOST_TEST_CONTEXT(name_of(element) << ", " << on.n_nodes) {
        BOOST_TEST((least.pressure - inverted.pressure).cwiseAbs().maxCoeff() <
                   1e-10 * inverted.peak_pressure());
        BOOST_TEST((least.gap - inverted.gap).cwiseAbs().maxCoeff() <
                   1e-11 * inverted.gap.maxCoeff());
        BOOST_TEST(relative_difference(least.approach(1), inverted.approach(1)) < 1e-12);
        BOOST_TEST(least.n_in_contact() == inverted.n_in_contact());
        BOOST_TEST(least.residuals.load < 1e-13 * load);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(one_or_two_nodes_bear_a_tiny_load) {
  for (const Index n_nodes : {41, 42}) {
    const Problem problem = cylinders_on(grid_of_width(0.24, n_nodes));
    const Solution s = solve_by_variational_method(problem, 1e-7);

    BOOST_TEST(s.n_in_contact() == (n_nodes % 2 == 1 ? 1 : 2));
    BOOST_TEST(relative_difference(s.line_load(), 1e-7) < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(other_pressures_of_the_same_load_have_more_energy) {
  for (const Element element : elements) {
    const Problem problem = cylinders_on(grid, element);
    const Solution s = solve_by_variational_method(problem, load);
    const double least = energy(problem, s);
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      for (const double size : {1e-4, 0.02385, 0.5}) {
        BOOST_TEST(energy(problem, disturbed(s, seed, size)) > least);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(a_small_disturbance_inside_adds_energy_of_second_order_only) {
  const Problem problem = cylinders_on(grid);
  const Solution s = solve_by_variational_method(problem, load);
  const auto excess = [&](double size) {
    Solution other = s;
    other.pressure[38] += size * s.peak_pressure();
    other.pressure[41] -= size * s.peak_pressure();
    return energy(problem, other) - energy(problem, s);
  };

  BOOST_TEST(std::abs(std::log2(excess(0.02) / excess(0.01)) - 2) < 1e-6);
}

BOOST_AUTO_TEST_CASE(methods_and_sides_agree_on_the_energy) {
  const Problem both = cylinders_on(grid);
  const Problem half = cylinders_on(one_sided_grid(0.2385, 39));
  const double least = energy(both, solve_by_variational_method(both, load));

  BOOST_TEST(relative_difference(energy(both, solve_by_matrix_inversion(both, load)), least) <
             1e-12);
  BOOST_TEST(relative_difference(energy(half, solve_by_variational_method(half, load)), least) <
             1e-12);
}

BOOST_AUTO_TEST_CASE(the_energy_of_one_uniform_element_is_that_of_its_own_displacement) {
  // p on the middle element alone: ½ p c (2c p/(πE*))(−T(0)) + h(0) p c, over E*.
  Problem problem = cylinders_on({5, 0.02385}, Element::uniform);
  problem.profile = Profile::tabulated({-1, -0.4, 0.3, 1}, {2.385, 2.385, 2.385, 2.385});
  Solution s =
      line_contact::to_solution(problem, 1, {VectorXd::Unit(5, 2), VectorXd::Zero(5), 0, 0, {}});
  const double c = 0.02385;
  const double p = s.pressure[2];
  const double self = 1 + std::log(2.);  // −T(0)
  const double expected =
      p * p * c * c * self / (std::numbers::pi * 913.7 * 913.7) + 2.385 * p * c / 913.7;

  BOOST_TEST(relative_difference(energy(problem, s), expected) < 1e-14);
}

BOOST_AUTO_TEST_CASE(the_energy_changes_with_the_load_by_the_approach) {
  // dU/dP = δ (Castigliano), with lengths in the logarithm in spacings: by central differences.
  const Problem problem = cylinders_on(grid);
  const auto energy_at = [&](double at) {
    return 913.7 * energy(problem, solve_by_variational_method(problem, at));
  };
  const double step = 1e-4 * load;
  const double derivative = (energy_at(load + step) - energy_at(load - step)) / (2 * step);

  BOOST_TEST(relative_difference(derivative,
                                 solve_by_variational_method(problem, load).approach_at_spacing) <
             1e-7);
}

BOOST_AUTO_TEST_CASE(products_grow_no_faster_than_the_root_of_the_nodes) {
  for (const Index n_nodes : {50, 200, 450}) {
    const Problem problem = cylinders_on(grid_of_width(0.24, n_nodes));
    const Solution s = solve_by_variational_method(problem, load);

    BOOST_TEST(s.work.products < 20 * std::sqrt(static_cast<double>(n_nodes)));
    BOOST_TEST(s.work.iterations == s.work.products / 2);
  }
}

BOOST_AUTO_TEST_CASE(the_residual_of_the_pressure_is_that_of_the_gap) {
  const Problem problem = cylinders_on(grid);
  const Solution s = solve_by_variational_method(problem, load);

  BOOST_TEST(relative_difference(s.residuals.pressure, s.residuals.gap * s.pressure_per_phi) <
             1e-12);
  BOOST_TEST(s.residuals.pressure < 1e-10 * s.peak_pressure());
}

BOOST_AUTO_TEST_CASE(what_cannot_be_solved_is_refused_by_name) {
  const auto names = [](const char* quantity) {
    return [=](const InvalidQuantity& e) { return e.quantity() == quantity; };
  };
  BOOST_CHECK_EXCEPTION(solve_by_variational_method(cylinders_on(grid), 0), InvalidQuantity,
                        names("load"));
  BOOST_CHECK_EXCEPTION(solve_by_variational_method(cylinders_on(grid_of_width(0.1, 41)), load),
                        InvalidQuantity, names("domain"));
  BOOST_CHECK_EXCEPTION(
      solve_by_variational_method(cylinders_on(grid_of_width(1, line_contact::max_dense_nodes + 1)),
                                  load),
      InvalidQuantity, names("nodes"));
}

BOOST_AUTO_TEST_SUITE_END()
