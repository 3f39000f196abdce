// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/load.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "system/require.hpp"

BOOST_AUTO_TEST_SUITE(load_test)

using elasticity::distributed_load;
using elasticity::Load;
using sys::InvalidQuantity;

namespace {

double linear(double s) {
  return 2.385 - s;
}

}  // namespace

BOOST_AUTO_TEST_CASE(an_arbitrary_load_is_split_at_its_breakpoints) {
  const Load load = distributed_load(linear, nullptr, {-1, 0.25, 2});

  BOOST_TEST(load.normal.pieces().size() == 2U);
  BOOST_TEST(load.normal(0.25) == linear(0.25));
  BOOST_TEST(load.normal(2.5) == 0);
  BOOST_TEST(load.tangential.is_zero());
}

BOOST_AUTO_TEST_CASE(a_shear_alone_is_a_load) {
  const Load load = distributed_load(nullptr, linear, {-1, 2});

  BOOST_TEST(load.normal.is_zero());
  BOOST_TEST(load.tangential(0.5) == linear(0.5));
}

BOOST_AUTO_TEST_CASE(breakpoints_must_rise_and_be_two_at_least) {
  BOOST_CHECK_THROW(distributed_load(linear, nullptr, {1}), InvalidQuantity);
  BOOST_CHECK_THROW(distributed_load(linear, nullptr, {0, 1, 0.5}), InvalidQuantity);
  BOOST_CHECK_THROW(distributed_load(linear, nullptr, {0, 0}), InvalidQuantity);
}

BOOST_AUTO_TEST_CASE(a_traction_that_is_infinite_at_an_end_is_refused) {
  const auto punch = [](double s) { return 1 / std::sqrt(1 - s * s); };

  BOOST_CHECK_THROW(distributed_load(punch, nullptr, {-1, 1}), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
