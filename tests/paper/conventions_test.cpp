// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/conventions.hpp"

#include <boost/test/unit_test.hpp>
#include <vector>

BOOST_AUTO_TEST_SUITE(conventions_test)

using paper::decimals_of;

BOOST_AUTO_TEST_CASE(the_point_with_most_decimals_decides) {
  BOOST_TEST(decimals_of({0, 0.005, 0.01}) == 3);
  BOOST_TEST(decimals_of({1, 2.5, 3}) == 1);
  BOOST_TEST(decimals_of({-0.25, 4}) == 2);
  BOOST_TEST(decimals_of({3e-8}) == 8);
}

BOOST_AUTO_TEST_CASE(whole_numbers_and_no_points_have_none) {
  BOOST_TEST(decimals_of({0, 1, -25000}) == 0);
  BOOST_TEST(decimals_of({}) == 0);
}

BOOST_AUTO_TEST_CASE(rounding_of_a_sum_adds_no_decimals) {
  std::vector<double> points;
  for (int i = 0; i <= 10; ++i) points.push_back(i * 0.005);
  points.push_back(0.1 + 0.2);

  BOOST_TEST(decimals_of(points) == 3);
}

BOOST_AUTO_TEST_CASE(what_no_decimals_print_exactly_has_nine) {
  BOOST_TEST(decimals_of({1.0 / 3}) == 9);
  BOOST_TEST(decimals_of({1e-12}) == 9);
}

BOOST_AUTO_TEST_SUITE_END()
