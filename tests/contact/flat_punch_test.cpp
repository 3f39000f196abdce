// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/flat_punch.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "contact/cauchy_integral.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(flat_punch_test)

using contact::FlatPunch;
using std::numbers::pi;
using sys::InvalidQuantity;

namespace {

constexpr double modulus = 913.7;
constexpr double a = 0.2385;
constexpr double load = 3.461;
const FlatPunch punch(modulus, a, load);

double cauchy(double x) {
  return cauchy_integral([](double s) { return punch.pressure(s); }, a, x);
}

// −∂(u_z1 + u_z2)/∂x by eq. (2): u_z is positive into the body.
double slope_outside(double x) {
  return 2 / (pi * modulus) * cauchy(x);
}

}  // namespace

BOOST_AUTO_TEST_CASE(pressure_integrates_to_the_load) {
  // Far off, x ∫ p/(x−s) ds → P, to (a/x)²/2.
  const double far = 2.385e7;

  BOOST_TEST(tolerance::relative_difference(far * cauchy(far), load) < 1e-13);
}

BOOST_AUTO_TEST_CASE(pressure_leaves_the_surface_flat_by_equation_1a) {
  // The two sides of the principal value, each of the order of P/a, cancel to rounding.
  for (const double share : {-0.947, -0.313, 0.1234, 0.7713}) {
    BOOST_TEST(std::abs(cauchy(share * a)) < 1e-13 * load / a);
  }
}

BOOST_AUTO_TEST_CASE(the_surface_rises_with_the_slope_of_equation_2) {
  // The rise between two points, by quadrature of a quadrature.
  for (const double begin : {1.0137, 1.573, 3.091}) {
    const double from = begin * a;
    const double to = 2.385 * from;
    const double rise =
        numerics::Quadrature().smooth(slope_outside, from, to, 1e-15, {"rise", from}).value;
    BOOST_TEST(tolerance::relative_difference(punch.surface_rise(to) - punch.surface_rise(-from),
                                              rise) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(the_surface_rises_as_a_root_from_the_edge) {
  // arcosh(1 + ε) = √(2ε) (1 − ε/12 + …)
  const double x = a * (1 + 0x1p-40);
  const double expected = 2 * load / (pi * modulus) * std::sqrt(2 * (x - a) / a);

  BOOST_TEST(tolerance::relative_difference(punch.surface_rise(x), expected) < 1e-12);
  BOOST_TEST(punch.surface_rise(a) == 0);
  BOOST_TEST(punch.surface_rise(-0.3 * a) == 0);
}

BOOST_AUTO_TEST_CASE(pressure_is_infinite_at_the_edge_and_zero_beyond) {
  BOOST_TEST(punch.pressure(a) == std::numeric_limits<double>::infinity());
  BOOST_TEST(punch.pressure(-a) == std::numeric_limits<double>::infinity());
  BOOST_TEST(punch.pressure(1.001 * a) == 0);
  BOOST_TEST(punch.pressure(-3 * a) == 0);
  BOOST_TEST(punch.half_width() == a);
  BOOST_TEST(punch.line_load() == load);
}

BOOST_AUTO_TEST_CASE(inputs_must_be_positive) {
  BOOST_CHECK_THROW(FlatPunch(0, a, load), InvalidQuantity);
  BOOST_CHECK_THROW(FlatPunch(modulus, -a, load), InvalidQuantity);
  BOOST_CHECK_THROW(FlatPunch(modulus, a, 0), InvalidQuantity);
  BOOST_CHECK_THROW(FlatPunch(modulus, a, std::nan("")), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
