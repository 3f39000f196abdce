// SPDX-License-Identifier: GPL-3.0-or-later
// Three methods that share the influence coefficients and nothing else: the dense matrix, the
// variational method and the fast Fourier transform have to find the same pressures.
#include "point_contact/solver/methods.hpp"

#include <boost/test/unit_test.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "point_contact/rough_surface.hpp"
#include "point_contact/solver/influence_operator.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(matrix_inversion_test)

using point_contact::Element;
using point_contact::hexagonal_grid;
using point_contact::Problem;
using point_contact::Profile;
using point_contact::rectangular_grid;
using point_contact::Solution;
using point_contact::solve_by_matrix_inversion;
using point_contact::solve_by_variational_method;
using point_contact::solve_for_load;
using point_contact::square_grid;
using sys::InvalidQuantity;
using tolerance::relative_difference;

namespace {

constexpr double modulus = 913.7;

struct Case {
  std::string name;
  Problem problem;
  double load;
};

std::vector<Case> cases() {
  const Profile sphere = Profile::paraboloid(1.3);
  const auto rough = Profile::height_map(rough_surface(41, 0.02), 1.0 / 40);
  return {
      {"sphere on forces", {sphere, modulus, square_grid(1, 24), Element::point}, 60},
      {"sphere on squares", {sphere, modulus, square_grid(1, 24), Element::uniform}, 60},
      {"sphere on hats", {sphere, modulus, square_grid(1, 25), Element::bilinear}, 60},
      {"sphere on pyramids", {sphere, modulus, hexagonal_grid(1, 26), Element::pyramid}, 30},
      {"ellipsoid",
       {Profile::elliptic_paraboloid(0.4, 4), modulus, rectangular_grid(1.6, 0.6, 22),
        Element::pyramid},
       30},
      {"cone", {Profile::cone(0.3), modulus, square_grid(1, 24), Element::bilinear}, 60},
      {"rounded punch",
       {Profile::rounded_punch(0.2, 5), modulus, square_grid(1, 24), Element::pyramid},
       80},
      {"flat punch", {Profile::flat_punch(0.4), modulus, square_grid(1, 24), Element::uniform}, 80},
      {"rough", {rough, modulus, square_grid(0.97, 32), Element::bilinear}, 10},
  };
}

double difference(const Solution& one, const Solution& other) {
  return (one.pressure - other.pressure).cwiseAbs().maxCoeff() / one.peak_pressure();
}

}  // namespace

BOOST_AUTO_TEST_CASE(three_methods_find_the_same_pressures) {
  for (const Case& one : cases()) {
    const Solution inverted = solve_by_matrix_inversion(one.problem, one.load);
    const Solution by_fft = solve_for_load(one.problem, one.load, {.tolerance = 1e-11});
    const Solution variational =
        solve_by_variational_method(one.problem, one.load, {.tolerance = 1e-11});
    BOOST_TEST_CONTEXT(one.name) {
      BOOST_TEST(inverted.n_in_contact() > 30);
      BOOST_TEST(inverted.n_in_contact() < one.problem.grid.size());
      BOOST_TEST(difference(inverted, by_fft) < 1e-9);
      BOOST_TEST(difference(inverted, variational) < 1e-9);
      BOOST_TEST(relative_difference(by_fft.approach, inverted.approach) < 1e-10);
      BOOST_TEST(relative_difference(variational.approach, inverted.approach) < 1e-10);
      BOOST_TEST(relative_difference(inverted.load(), one.load) < 1e-12);
    }
  }
}

BOOST_AUTO_TEST_CASE(gaps_agree_too) {
  const Case sphere = cases()[3];
  const Solution inverted = solve_by_matrix_inversion(sphere.problem, sphere.load);
  const Solution by_fft = solve_for_load(sphere.problem, sphere.load, {.tolerance = 1e-11});

  BOOST_TEST((inverted.gap - by_fft.gap).cwiseAbs().maxCoeff() < 1e-11 * inverted.approach);
  BOOST_TEST(inverted.residuals.gap < 1e-13 * inverted.approach);
}

// A(½ pᵀu + hᵀp) of a solution, A the area of a cell: the energy that contact makes least.
double energy(const Problem& problem, const Solution& solution) {
  const point_contact::RowTeam team(1);
  point_contact::InfluenceOperator influence(
      point_contact::ElementPotential(problem.element, problem.grid.lattice), problem.grid, team);
  Eigen::VectorXd u;
  influence.displacements(solution.pressure, u);
  u *= problem.grid.spacing() / (std::numbers::pi * problem.contact_modulus);
  return problem.grid.lattice.cell_area() *
         solution.pressure.dot(u / 2 + initial_gaps(problem, team));
}

BOOST_AUTO_TEST_CASE(the_energy_of_contact_is_less_than_that_of_its_neighbours) {
  const Case sphere = cases()[3];
  const Solution inverted = solve_by_matrix_inversion(sphere.problem, sphere.load);
  const double least = energy(sphere.problem, inverted);
  const double peak = inverted.peak_pressure();
  for (const double step : {1e-3, -1e-3}) {
    // a pressure moved from one node in contact to its neighbour
    Solution neighbour = inverted;
    Eigen::Index at = 0;
    inverted.pressure.maxCoeff(&at);
    neighbour.pressure[at] += step * peak;
    neighbour.pressure[at + 1] -= step * peak;
    BOOST_TEST(energy(sphere.problem, neighbour) > least);
  }
}

BOOST_AUTO_TEST_CASE(bad_input_is_refused) {
  const Problem problem{Profile::paraboloid(1.3), modulus, square_grid(1, 24), Element::bilinear};
  BOOST_CHECK_THROW(solve_by_matrix_inversion(problem, 0), InvalidQuantity);
  BOOST_CHECK_THROW(solve_by_matrix_inversion(problem, 1e6), InvalidQuantity);  // to the ends
  Problem large = problem;
  large.grid = square_grid(1, 101);
  BOOST_CHECK_THROW(solve_by_matrix_inversion(large, 1), InvalidQuantity);
  BOOST_CHECK_THROW(solve_by_variational_method(problem, -1), InvalidQuantity);
  BOOST_CHECK_THROW(solve_by_variational_method(problem, 60, {.tolerance = 1e-14}),
                    InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
