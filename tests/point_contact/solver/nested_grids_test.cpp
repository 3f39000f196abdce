// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/methods.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "point_contact/rough_surface.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(nested_grids_test)

using Eigen::Index;
using point_contact::Control;
using point_contact::Element;
using point_contact::ElementLoads;
using point_contact::Problem;
using point_contact::Profile;
using point_contact::Solution;
using point_contact::solve_by_variational_method;
using point_contact::solve_on_nested_grids;
using point_contact::square_grid;
using point_contact::total_phi;
using sys::InvalidQuantity;
using tolerance::relative_difference;

namespace {

constexpr double modulus = 913.7;

Problem sphere_on(Index n) {
  return {Profile::paraboloid(1.3), modulus, square_grid(1, n), Element::bilinear};
}

}  // namespace

BOOST_AUTO_TEST_CASE(loads_of_elements_add_up_to_that_of_the_contact) {
  const Problem problem = sphere_on(70);
  const ElementLoads loads = solve_on_nested_grids(problem, Control::load, 40, {});

  BOOST_TEST(relative_difference(loads.phi.sum(), total_phi(problem, 40)) < 1e-13);
  BOOST_TEST(loads.error <= 1e-8);
  BOOST_TEST(loads.phi.minCoeff() == 0);
}

BOOST_AUTO_TEST_CASE(a_rough_contact_of_many_patches_settles) {
  const Problem problem{Profile::height_map(rough_surface(101, 0.05), 0.01), modulus,
                        square_grid(0.99, 128), Element::bilinear};
  for (const double load : {0.5, 5.0}) {
    const ElementLoads loads =
        solve_on_nested_grids(problem, Control::load, load, {.tolerance = 1e-9});
    const Solution reference = solve_by_variational_method(problem, load, {.tolerance = 1e-9});
    const double scale = reference.peak_pressure() / loads.phi.maxCoeff();
    BOOST_TEST((scale * loads.phi - reference.pressure).cwiseAbs().maxCoeff() <
               1e-7 * reference.peak_pressure());
    BOOST_TEST(loads.work.products < reference.work.products);
  }
}

BOOST_AUTO_TEST_CASE(contact_that_a_coarse_grid_overlooks_is_found_on_the_finest) {
  // A thorn on one node of the finest grid, far from the sphere's contact.
  Problem problem = sphere_on(128);
  const auto thorn = problem.grid.node(Index{100}, Index{90});
  Eigen::ArrayXXd heights(257, 257);
  for (Index j = 0; j < 257; ++j) {
    for (Index i = 0; i < 257; ++i) {
      const double x = static_cast<double>(i - 128) / 256;
      const double y = static_cast<double>(j - 128) / 256;
      const double from_thorn = std::hypot(x - thorn.x(), y - thorn.y());
      heights(i, j) = 1.3 * (x * x + y * y) / 2 - (from_thorn < 0.004 ? 0.2 : 0);
    }
  }
  problem.profile = Profile::height_map(heights, 1.0 / 256);
  const ElementLoads loads = solve_on_nested_grids(problem, Control::load, 5, {});

  BOOST_TEST(loads.phi[problem.grid.index(100, 90)] > 0);
}

BOOST_AUTO_TEST_CASE(contact_may_fill_the_grid) {
  const Problem problem = sphere_on(64);
  const ElementLoads loads = solve_on_nested_grids(problem, Control::load, 1e5, {});

  BOOST_TEST((loads.phi.array() > 0).all());
  BOOST_TEST(loads.phi[0] > 2 * loads.phi[problem.grid.index(32, 32)]);  // nearly a flat punch
}

BOOST_AUTO_TEST_CASE(a_small_approach_touches_few_nodes) {
  // Less than the gap of the next nodes: a node or four carry.
  const Problem problem = sphere_on(65);
  const ElementLoads loads = solve_on_nested_grids(problem, Control::approach, 1e-4, {});

  BOOST_TEST((loads.phi.array() > 0).count() == 1);
  BOOST_TEST(loads.approach == 1e-4);
}

BOOST_AUTO_TEST_CASE(a_contact_between_the_nodes_of_coarse_grids_is_found) {
  // at the four nodes around the middle h = 2e-5; at those of the next coarser grid four times that
  const Problem problem = sphere_on(128);
  const ElementLoads sphere = solve_on_nested_grids(problem, Control::approach, 5e-5, {});
  BOOST_TEST((sphere.phi.array() > 0).count() == 4);

  const Problem punch{Profile::flat_punch(0.006), modulus, square_grid(1, 128), Element::uniform};
  const ElementLoads loads = solve_on_nested_grids(punch, Control::load, 1, {});
  BOOST_TEST((loads.phi.array() > 0).count() == 4);
}

BOOST_AUTO_TEST_CASE(a_tolerance_that_rounding_keeps_out_of_reach_is_refused) {
  BOOST_CHECK_THROW(solve_on_nested_grids(sphere_on(128), Control::load, 40, {.tolerance = 1e-17}),
                    InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
