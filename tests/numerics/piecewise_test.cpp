// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/piecewise.hpp"

#include <boost/test/unit_test.hpp>
#include <limits>

#include "system/require.hpp"

BOOST_AUTO_TEST_SUITE(piecewise_test)

using numerics::Piece;
using numerics::PiecewiseFunction;
using sys::InvalidQuantity;

namespace {

double one(double) {
  return 1;
}
double three(double) {
  return 3;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_jump_has_the_mean_of_its_limits) {
  const PiecewiseFunction f({{-1, 0.5, one}, {0.5, 2, three}});

  BOOST_TEST(f(0.25) == 1);
  BOOST_TEST(f(0.5) == 2);
  BOOST_TEST(f(1.75) == 3);
}

BOOST_AUTO_TEST_CASE(it_is_zero_outside_and_half_at_the_outer_ends) {
  const PiecewiseFunction f({{-1, 0.5, three}});

  BOOST_TEST(f(-1.25) == 0);
  BOOST_TEST(f(-1) == 1.5);
  BOOST_TEST(f(0.75) == 0);
}

BOOST_AUTO_TEST_CASE(its_scale_is_its_greatest_magnitude) {
  const PiecewiseFunction f({{-1, 1, [](double s) { return s - 4; }}});

  BOOST_TEST(f.scale() == 5);
}

BOOST_AUTO_TEST_CASE(pieces_that_overlap_are_refused) {
  BOOST_CHECK_THROW(PiecewiseFunction({{0, 2, one}, {1, 3, one}}), InvalidQuantity);
}

BOOST_AUTO_TEST_CASE(a_piece_of_no_width_is_refused) {
  BOOST_CHECK_THROW(PiecewiseFunction({{1, 1, one}}), InvalidQuantity);
  BOOST_CHECK_THROW(PiecewiseFunction({{2, 1, one}}), InvalidQuantity);
}

BOOST_AUTO_TEST_CASE(ends_and_values_that_are_not_finite_are_refused) {
  const double infinity = std::numeric_limits<double>::infinity();

  BOOST_CHECK_THROW(PiecewiseFunction({{0, infinity, one}}), InvalidQuantity);
  BOOST_CHECK_THROW(PiecewiseFunction({{0, 1, [](double s) { return 1 / s; }}}), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
