// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/problem.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <utility>

#include "system/require.hpp"

BOOST_AUTO_TEST_SUITE(problem_test)

using Eigen::Index;
using point_contact::initial_gaps;
using point_contact::Problem;
using point_contact::Profile;
using point_contact::RowTeam;
using point_contact::square_grid;
using sys::InvalidQuantity;

BOOST_AUTO_TEST_CASE(initial_gaps_are_those_of_the_profile_at_the_nodes) {
  const Problem problem{Profile::elliptic_paraboloid(0.3, 2), 1, square_grid(1, 12)};
  const Eigen::VectorXd gaps = initial_gaps(problem, RowTeam(2));
  for (const auto& [i, j] : {std::pair<Index, Index>{0, 0}, {3, 7}, {11, 2}}) {
    BOOST_TEST(gaps[problem.grid.index(i, j)] == problem.profile.gap(problem.grid.node(i, j)));
  }
}

BOOST_AUTO_TEST_CASE(a_grid_beyond_the_measured_surface_is_refused) {
  const Profile map = Profile::height_map(Eigen::ArrayXXd::Zero(11, 11), 0.1);
  BOOST_CHECK_NO_THROW(initial_gaps({map, 1, square_grid(1, 20)}, RowTeam(1)));
  BOOST_CHECK_EXCEPTION(initial_gaps({map, 1, square_grid(1.2, 20)}, RowTeam(1)), InvalidQuantity,
                        [](const InvalidQuantity& error) {
                          return error.allowed().find("measured surface") != std::string::npos;
                        });
}

BOOST_AUTO_TEST_CASE(bodies_without_modulus_or_extent_are_refused) {
  BOOST_CHECK_THROW(initial_gaps({Profile::paraboloid(1), 0, square_grid(1, 20)}, RowTeam(1)),
                    InvalidQuantity);
  // a punch between the nodes
  BOOST_CHECK_THROW(initial_gaps({Profile::flat_punch(1e-3), 1, square_grid(1, 20)}, RowTeam(1)),
                    InvalidQuantity);
  BOOST_CHECK_THROW(initial_gaps({Profile::paraboloid(1e300), 1, square_grid(1, 20)}, RowTeam(1)),
                    InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
