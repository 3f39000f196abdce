// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/estimate.hpp"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(estimate_test)

using numerics::Estimate;

BOOST_AUTO_TEST_CASE(errors_add_in_sums_and_in_differences) {
  const Estimate a{2.5, 0.25};
  const Estimate b{-1.25, 0.5};

  BOOST_TEST((a + b).value == 1.25);
  BOOST_TEST((a + b).abs_error == 0.75);
  BOOST_TEST((a - b).value == 3.75);
  BOOST_TEST((a - b).abs_error == 0.75);
}

BOOST_AUTO_TEST_CASE(a_negative_factor_leaves_the_error_positive) {
  const Estimate scaled = -4.0 * Estimate{2.5, 0.25};

  BOOST_TEST(scaled.value == -10.0);
  BOOST_TEST(scaled.abs_error == 1.0);
}

BOOST_AUTO_TEST_SUITE_END()
