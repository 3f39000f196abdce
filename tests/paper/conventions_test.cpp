// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/conventions.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

BOOST_AUTO_TEST_SUITE(conventions_test)

using paper::decimals_of;

BOOST_AUTO_TEST_CASE(a_printed_number_is_known_to_half_a_unit_of_its_last_place) {
  const auto close = boost::test_tools::tolerance(1e-12);
  BOOST_TEST(paper::as_estimate(parameters::PrintedNumber("1.594637E-06")).abs_error == 5e-13,
             close);
  BOOST_TEST(paper::as_estimate(parameters::PrintedNumber("-16.0")).abs_error == 0.05, close);
}

BOOST_AUTO_TEST_CASE(the_other_component_is_a_leg_of_the_triangle) {
  // 5² − 4² = 3²; difference and sum are each known to 0.001
  const auto other = paper::other_component(parameters::PrintedNumber("5.000"),
                                            parameters::PrintedNumber("4.000"));
  BOOST_TEST(other.value == 3, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(other.abs_error == 3 - std::sqrt(0.999 * 8.999), boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(the_point_with_the_most_decimals_decides) {
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

BOOST_AUTO_TEST_CASE(a_number_without_an_exact_decimal_has_nine_decimals) {
  BOOST_TEST(decimals_of({1.0 / 3}) == 9);
  BOOST_TEST(decimals_of({1e-12}) == 9);
}

BOOST_AUTO_TEST_SUITE_END()
