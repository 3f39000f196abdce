// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/piecewise.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

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

BOOST_AUTO_TEST_CASE(overlapping_pieces_are_rejected) {
  BOOST_CHECK_THROW(PiecewiseFunction({{0, 2, one}, {1, 3, one}}), InvalidQuantity);
}

BOOST_AUTO_TEST_CASE(a_piece_of_zero_width_is_rejected) {
  BOOST_CHECK_THROW(PiecewiseFunction({{1, 1, one}}), InvalidQuantity);
  BOOST_CHECK_THROW(PiecewiseFunction({{2, 1, one}}), InvalidQuantity);
}

BOOST_AUTO_TEST_CASE(ends_and_values_that_are_not_finite_are_rejected) {
  const double infinity = std::numeric_limits<double>::infinity();

  BOOST_CHECK_THROW(PiecewiseFunction({{0, infinity, one}}), InvalidQuantity);
  BOOST_CHECK_THROW(PiecewiseFunction({{0, 1, [](double s) { return 1 / s; }}}), InvalidQuantity);
}

BOOST_AUTO_TEST_CASE(polynomials_and_square_roots_are_not_cut) {
  const auto quartic = [](double s) { return 1 - s * s * s * s; };
  const auto ellipse = [](double s) { return std::sqrt((1 - s) * (1 + s)); };
  for (const std::function<double(double)>& f :
       {std::function<double(double)>(quartic), {ellipse}}) {
    BOOST_TEST(resolved(PiecewiseFunction({{-1, 1, f}})).pieces().size() == 1U);
  }
}

BOOST_AUTO_TEST_CASE(a_narrow_feature_is_cut_out_and_a_kink_is_found) {
  const auto bump = [](double s) { return 1 + std::exp(-std::pow((s - 0.2385) / 1e-3, 2)); };
  const PiecewiseFunction of_bump = resolved(PiecewiseFunction({{-1, 1, bump}}));
  double at_bump = 2;
  for (const Piece& piece : of_bump.pieces()) {
    if (piece.begin <= 0.2385 && 0.2385 <= piece.end) at_bump = piece.end - piece.begin;
  }
  BOOST_TEST(at_bump < 8e-3);
  BOOST_TEST(of_bump.pieces().size() < 64U);

  const auto kink = [](double s) { return std::abs(s - 0.2385); };
  const PiecewiseFunction of_kink = resolved(PiecewiseFunction({{-1, 1, kink}}));
  double nearest = 2;
  for (const Piece& piece : of_kink.pieces()) {
    nearest = std::min(nearest, std::abs(piece.end - 0.2385));
  }
  BOOST_TEST(nearest < 1e-10);
}

BOOST_AUTO_TEST_CASE(a_wave_that_evenly_spaced_probes_would_miss_is_found) {
  const auto wave = [](double s) { return std::sin(2048 * std::numbers::pi * (s + 1)); };
  BOOST_TEST(resolved(PiecewiseFunction({{-1, 1, wave}})).pieces().size() >= 256U);
}

BOOST_AUTO_TEST_SUITE_END()
