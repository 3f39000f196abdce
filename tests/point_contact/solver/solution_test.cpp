// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/solution.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(solution_test)

using Eigen::Index;
using Eigen::VectorXd;
using point_contact::Element;
using point_contact::ElementLoads;
using point_contact::Grid;
using point_contact::hexagonal_grid;
using point_contact::Problem;
using point_contact::Profile;
using point_contact::rectangular_grid;
using point_contact::Solution;
using point_contact::to_solution;
using point_contact::total_phi;
using point_contact::Vector2;
using tolerance::relative_difference;

namespace {

constexpr double modulus = 913.7;

Problem problem_on(const Grid& grid, Element element) {
  return {Profile::paraboloid(1), modulus, grid, element};
}

}  // namespace

BOOST_AUTO_TEST_CASE(pressures_follow_from_the_loads_of_elements) {
  const Problem problem = problem_on(rectangular_grid(2, 1, 10), Element::bilinear);
  ElementLoads loads;
  loads.phi = VectorXd::Zero(100);
  loads.phi[45] = 0.3;
  loads.phi[46] = 0.1;
  loads.gap = VectorXd::Constant(100, 0.5);
  loads.gap[45] = -2e-9;
  loads.gap[46] = 1e-9;
  loads.gap[7] = -3e-9;
  loads.error = 1e-6;
  const double spacing = std::sqrt(0.02);
  const double load = std::numbers::pi * modulus * spacing * 0.4;
  const Solution solution = to_solution(problem, 1.25 * load, loads);

  BOOST_TEST(relative_difference(solution.peak_pressure(),
                                 0.3 * std::numbers::pi * modulus / spacing) < 1e-14);
  BOOST_TEST(relative_difference(solution.load(), load) < 1e-14);
  BOOST_TEST(relative_difference(total_phi(problem, load), 0.4) < 1e-14);
  BOOST_TEST(solution.n_in_contact() == 2);
  BOOST_TEST(relative_difference(solution.contact_area(), 0.04) < 1e-14);
  BOOST_TEST(solution.residuals.gap == 2e-9);
  BOOST_TEST(solution.residuals.separation == 3e-9);
  BOOST_TEST(relative_difference(solution.residuals.load, load / 4) < 1e-13);
  BOOST_TEST(relative_difference(solution.residuals.pressure, 1e-6 * solution.peak_pressure()) <
             1e-14);
}

BOOST_AUTO_TEST_CASE(semi_axes_of_an_ellipsoidal_pressure_are_its_own_wherever_it_lies) {
  const Vector2 axes(0.7, 0.3);
  const double turn = 0.4;
  Grid grid = hexagonal_grid(3, 200);
  grid.centre = {0.1, -0.2};
  Solution solution{.grid = grid,
                    .element = Element::point,
                    .pressure = VectorXd::Zero(grid.size()),
                    .gap = {},
                    .approach = 0,
                    .work = {},
                    .residuals = {}};
  for (Index j = 0; j < grid.n2; ++j) {
    for (Index i = 0; i < grid.n1; ++i) {
      const Vector2 at = grid.node(i, j);
      const double x = (std::cos(turn) * at.x() + std::sin(turn) * at.y()) / axes.x();
      const double y = (std::cos(turn) * at.y() - std::sin(turn) * at.x()) / axes.y();
      const double square = 1 - x * x - y * y;
      if (square > 0) solution.pressure[grid.index(i, j)] = 1e-200 * std::sqrt(square);
    }
  }
  BOOST_TEST(relative_difference(solution.semi_axes()[0], 0.7) < 1e-3);
  BOOST_TEST(relative_difference(solution.semi_axes()[1], 0.3) < 1e-3);
}

BOOST_AUTO_TEST_CASE(one_element_has_its_own_second_moments) {
  // ⟨x²⟩ of a unit square is 1/12, of a hat on [−1, 1]² it is 1/6; of a hexagonal pyramid over
  // triangles of side 1, 3/24 = 1/8.
  const auto axes = [](Element element, const Grid& grid) {
    Solution solution{.grid = grid,
                      .element = element,
                      .pressure = VectorXd::Zero(grid.size()),
                      .gap = {},
                      .approach = 0,
                      .work = {},
                      .residuals = {}};
    solution.pressure[grid.index(3, 5)] = 2.385;
    return solution.semi_axes();
  };
  const Vector2 uniform = axes(Element::uniform, rectangular_grid(20, 10, 10));
  BOOST_TEST(relative_difference(uniform[0], std::sqrt(5.0 * 4 / 12)) < 1e-12);
  BOOST_TEST(relative_difference(uniform[1], std::sqrt(5.0 / 12)) < 1e-12);
  const Vector2 bilinear = axes(Element::bilinear, rectangular_grid(10, 10, 10));
  BOOST_TEST(relative_difference(bilinear[0], std::sqrt(5.0 / 6)) < 1e-12);
  const Vector2 pyramid = axes(Element::pyramid, hexagonal_grid(10, 10));
  BOOST_TEST(relative_difference(pyramid[0], std::sqrt(5.0 / 8)) < 1e-7);
  BOOST_TEST(relative_difference(pyramid[1], std::sqrt(5.0 / 8)) < 1e-7);
}

BOOST_AUTO_TEST_CASE(loads_must_be_positive_and_their_squares_numbers) {
  const Problem problem = problem_on(rectangular_grid(2, 1, 10), Element::bilinear);
  BOOST_CHECK_THROW(total_phi(problem, 0), sys::InvalidQuantity);
  BOOST_CHECK_THROW(total_phi(problem, 1e150), sys::InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
