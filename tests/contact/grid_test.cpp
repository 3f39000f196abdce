// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/grid.hpp"

#include <boost/test/unit_test.hpp>

#include "numerics/require.hpp"
#include "tolerances.hpp"

using contact::Grid;
using contact::grid_around;
using numerics::InvalidQuantity;

BOOST_AUTO_TEST_CASE(nodes_lie_symmetrically_about_the_point_of_first_contact) {
  for (const long n_nodes : {5L, 6L, 41L}) {
    const Grid grid = grid_around(2.385, n_nodes);
    const Eigen::VectorXd x = grid.nodes();
    BOOST_TEST(x.size() == n_nodes);
    BOOST_TEST((x + x.reverse()).cwiseAbs().maxCoeff() == 0);
  }
}

BOOST_AUTO_TEST_CASE(there_is_a_free_node_on_either_side_of_the_contact) {
  for (const long n_nodes : {5L, 6L, 7L, 41L, 1000L}) {
    const Grid grid = grid_around(2.385, n_nodes);
    BOOST_TEST(grid.x(n_nodes - 2) >= 2.385 * 1.0999999);
  }
}

BOOST_AUTO_TEST_CASE(ninety_one_nodes_put_40_elements_on_the_half_width) {
  BOOST_TEST(tolerance::relative_difference(grid_around(1, 91).spacing, 1.0 / 40) < 1e-15);
}

BOOST_AUTO_TEST_CASE(too_few_or_too_many_nodes_are_refused) {
  BOOST_CHECK_THROW(grid_around(1, 4), InvalidQuantity);
  BOOST_CHECK_THROW(grid_around(1, -7), InvalidQuantity);
  BOOST_CHECK_THROW(grid_around(1, contact::max_nodes + 1), InvalidQuantity);
  BOOST_CHECK_THROW(grid_around(0, 41), InvalidQuantity);
}
