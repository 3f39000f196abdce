// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/solution.hpp"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(solution_test)

using Eigen::Vector4d;

BOOST_AUTO_TEST_CASE(a_gap_in_contact_counts_to_either_side_and_outside_only_a_penetration) {
  const Vector4d pressure(0, 2, 1, 0);

  const auto of_both = contact::residuals_of_gaps(pressure, Vector4d(-0.05, 0.01, -0.03, 0.2));
  BOOST_TEST(of_both.gap == 0.03);
  BOOST_TEST(of_both.separation == 0.05);
  BOOST_TEST(of_both.load == 0);

  BOOST_TEST(contact::residuals_of_gaps(pressure, Vector4d(0.1, 0, 0, 0.2)).separation == 0);
}

BOOST_AUTO_TEST_SUITE_END()
