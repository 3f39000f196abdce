// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/nested_grids.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "line_contact/dense_methods.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(nested_grids_test)

using Eigen::Index;
using Eigen::VectorXd;
using line_contact::Element;
using line_contact::element_loads;
using line_contact::ElementLoads;
using line_contact::grid_of_width;
using line_contact::influence_coefficient;
using line_contact::NestedSolution;
using line_contact::Problem;
using line_contact::Profile;
using line_contact::Solution;
using line_contact::solve_by_matrix_inversion;
using line_contact::solve_on_nested_grids;
using line_contact::total_phi;
using sys::InvalidQuantity;
using tolerance::relative_difference;

namespace {

constexpr double modulus = 913.7;
constexpr double load = 3.461;

Problem parabola_on(double width, Index n_nodes, double centre = 0) {
  return {Profile::parabola(0.571), modulus, grid_of_width(width, n_nodes, centre),
          Element::triangular};
}

// A parabola with a thorn at x = 0.401, narrower than the spacing of a coarse grid.
Problem thorn_on(Index n_nodes, double height) {
  std::vector<double> x, gap;
  for (int i = -500; i <= 500; ++i) {
    x.push_back(0.001 * i);
    gap.push_back(0.571 / 2 * x.back() * x.back());
  }
  gap[901] -= height;
  return {Profile::tabulated(x, gap), modulus, grid_of_width(0.99, n_nodes), Element::triangular};
}

}  // namespace

BOOST_AUTO_TEST_CASE(loads_of_elements_add_up_to_that_of_the_contact) {
  // Σφ = 2P/(πE*).
  const Problem problem = parabola_on(0.25, 300);
  const double total = 2 * load / (std::numbers::pi * modulus);

  BOOST_TEST(relative_difference(total_phi(problem, load), total) < 1e-15);
  BOOST_TEST(relative_difference(solve_on_nested_grids(problem, load, 1e-10).phi.sum(), total) <
             1e-14);
}

BOOST_AUTO_TEST_CASE(the_solution_stands_on_the_finest_grid) {
  const NestedSolution nested = solve_on_nested_grids(parabola_on(0.25, 777, 0.01), load, 1e-10);

  BOOST_TEST(nested.grid.n_nodes == 777);
  BOOST_TEST(nested.grid.centre == 0.01);
  BOOST_TEST(nested.phi.size() == 777);
  BOOST_TEST(nested.gap.size() == 777);
  BOOST_TEST(nested.error <= 1e-10);
  BOOST_TEST(nested.phi.minCoeff() == 0);
}

BOOST_AUTO_TEST_CASE(the_gap_is_none_in_contact_and_positive_outside) {
  const NestedSolution nested = solve_on_nested_grids(parabola_on(0.25, 900), load, 1e-11);
  double sum_in_contact = 0;
  for (Index i = 0; i < nested.phi.size(); ++i) {
    if (nested.phi[i] == 0) {
      BOOST_TEST(nested.gap[i] > -1e-11 * nested.phi.maxCoeff());
      continue;
    }
    sum_in_contact += nested.gap[i];
    BOOST_TEST(std::abs(nested.gap[i]) < 1e-10 * nested.phi.maxCoeff());
  }
  BOOST_TEST(std::abs(sum_in_contact) < 1e-11 * nested.gap.maxCoeff());
}

BOOST_AUTO_TEST_CASE(contact_that_a_coarse_grid_overlooks_is_found_on_the_finest) {
  // By the gap over the whole grid, since the thorn lies far from the window of the contact.
  for (const double height : {0.047, 0.06}) {
    const Problem problem = thorn_on(700, height);
    const NestedSolution nested = solve_on_nested_grids(problem, load, 1e-12);
    const Solution inverted = solve_by_matrix_inversion(problem, load);
    const VectorXd phi = inverted.pressure / inverted.pressure_per_phi;

    BOOST_TEST((nested.phi.tail(130).array() > 0).count() > 0);
    BOOST_TEST((nested.phi - phi).cwiseAbs().maxCoeff() < 1e-10 * phi.maxCoeff());
    BOOST_TEST((nested.gap - inverted.gap).cwiseAbs().maxCoeff() < 1e-10 * phi.maxCoeff());
  }
}

BOOST_AUTO_TEST_CASE(contact_off_the_middle_of_the_grid_is_found) {
  for (const double centre : {0.0, 0.031, -0.11}) {
    const Problem problem = parabola_on(0.5, 517, centre);
    const NestedSolution nested = solve_on_nested_grids(problem, load, 1e-12);
    const Solution inverted = solve_by_matrix_inversion(problem, load);
    const VectorXd phi = inverted.pressure / inverted.pressure_per_phi;

    BOOST_TEST((nested.phi - phi).cwiseAbs().maxCoeff() < 1e-10 * phi.maxCoeff());
  }
}

BOOST_AUTO_TEST_CASE(contact_may_fill_the_grid) {
  for (const Index n_nodes : {100, 1000}) {
    const NestedSolution nested = solve_on_nested_grids(parabola_on(0.02385, n_nodes), load, 1e-10);

    BOOST_TEST((nested.phi.array() > 0).all());
    BOOST_TEST(nested.phi[0] > 2 * nested.phi[n_nodes / 2]);  // nearly a flat punch
    BOOST_TEST((nested.phi - nested.phi.reverse()).cwiseAbs().maxCoeff() <
               1e-9 * nested.phi.maxCoeff());
  }
}

BOOST_AUTO_TEST_CASE(contact_may_be_at_one_end_of_the_grid_only) {
  const NestedSolution nested = solve_on_nested_grids(parabola_on(0.2, 600, 0.12), load, 1e-10);

  BOOST_TEST(nested.phi[0] > 0);
  BOOST_TEST(nested.phi[599] == 0);
}

BOOST_AUTO_TEST_CASE(the_approach_is_that_of_matrix_inversion) {
  for (const Element element : {Element::point, Element::uniform, Element::triangular}) {
    Problem problem = parabola_on(0.25, 200, 0.013);
    problem.element = element;
    NestedSolution nested = solve_on_nested_grids(problem, load, 1e-13);
    const VectorXd phi = nested.phi;
    const ElementLoads loads = element_loads(problem, std::move(nested));
    const Solution inverted = solve_by_matrix_inversion(problem, load);

    BOOST_TEST(relative_difference(loads.approach_at_spacing, inverted.approach_at_spacing) <
               1e-12);
    BOOST_TEST((loads.phi == phi));
    BOOST_TEST(loads.error <= 1e-13);
    BOOST_TEST(loads.work.revisions > 0);
  }
}

BOOST_AUTO_TEST_CASE(the_gap_and_the_approach_belong_together_also_where_the_tolerance_is_poor) {
  // δ = u_z1 + u_z2 + h − gap at every node, in contact or not.
  const Problem problem = parabola_on(0.25, 150);
  const ElementLoads loads = element_loads(problem, solve_on_nested_grids(problem, load, 1e-3));
  for (const Index i : {0, 40, 75, 149}) {
    double displacement = 0;
    for (Index j = 0; j < 150; ++j) {
      displacement -=
          influence_coefficient(Element::triangular, static_cast<double>(i - j)) * loads.phi[j];
    }
    const double approach = displacement + problem.profile.gap(problem.grid.x(i)) - loads.gap[i];
    BOOST_TEST(relative_difference(approach, loads.approach_at_spacing) < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(a_tolerance_below_rounding_is_an_error) {
  BOOST_CHECK_THROW(solve_on_nested_grids(parabola_on(0.25, 400), load, 1e-19), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
