// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/closed_forms/tangent.hpp"

#include <boost/test/unit_test.hpp>

#include "multiprecision.hpp"
#include "random_inputs.hpp"

BOOST_AUTO_TEST_SUITE(tangent_test)

BOOST_AUTO_TEST_CASE(the_excess_over_the_arctangent_is_right_to_rounding) {
  RandomInputs random(11);
  for (int i = 0; i < 1000; ++i) {
    const double w = random.log_uniform(1e-9, 1e9);
    const Precise exact = Precise(w) - atan(Precise(w));
    const double value = point_contact::excess_over_arctangent(w);
    BOOST_TEST(static_cast<double>(abs(value / exact - 1)) < 1e-15, "at " << w);
  }
  BOOST_TEST(point_contact::excess_over_arctangent(0) == 0);
}

BOOST_AUTO_TEST_SUITE_END()
