// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/wedge.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "numerics/quadrature.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(wedge_test)

using line_contact::Wedge;
using std::numbers::pi;
using sys::InvalidQuantity;

namespace {

constexpr double modulus = 913.7;
constexpr double slope = 0.03719;
constexpr double load = 3.461;
const Wedge wedge(modulus, slope, load);
const double a = wedge.half_width();

// Over s = a/cosh u the pressure is smooth and infinite nowhere; beyond u = 60 the rest is less
// than 1e-23 of the whole.
constexpr double end = 60;

// ∫ p(s)/(x−s) ds over both sides = 2x ∫₀ᵃ p(s)/(x²−s²) ds, with ds = −s tanh(u) du. Inside,
// x²−s² = x² sinh(u−u₀) sinh(u+u₀)/cosh²u has its zero at x = a/cosh u₀.
double cauchy(double x) {
  numerics::Quadrature quadrature;
  const double abs_tolerance = 1e-13 * load / a;
  if (std::abs(x) > a) {
    const auto f = [=](double u) {
      const double s = a / std::cosh(u);
      return 2 * x * wedge.pressure(s) * s * std::tanh(u) / ((x - s) * (x + s));
    };
    return quadrature.adaptive(f, 0, end, abs_tolerance, {"slope", x}).value;
  }
  const double pole = std::acosh(a / std::abs(x));
  const auto f = [=](double u) {
    const double s = a / std::cosh(u);
    const double sinhc = u == pole ? 1 : std::sinh(u - pole) / (u - pole);
    return 2 * wedge.pressure(s) * a * std::sinh(u) / (x * sinhc * std::sinh(u + pole));
  };
  return quadrature.principal_value(f, 0, end, pole, abs_tolerance, {"slope", x}).value;
}

double slope_outside(double x) {
  return slope - 2 / (pi * modulus) * cauchy(x);
}

}  // namespace

BOOST_AUTO_TEST_CASE(pressure_integrates_to_the_load) {
  const auto f = [](double u) {
    const double s = a / std::cosh(u);
    return 2 * wedge.pressure(s) * s * std::tanh(u);
  };
  const double total = numerics::Quadrature().adaptive(f, 0, end, 1e-13 * load, {"load", 0}).value;

  BOOST_TEST(tolerance::relative_difference(total, load) < 1e-12);
}

BOOST_AUTO_TEST_CASE(pressure_closes_the_gap_by_equation_1a) {
  // what the quadrature is asked for, times ten
  for (const double share : {-0.947, -0.313, 0.01234, 0.7713}) {
    const double fall = 2 / (pi * modulus) * cauchy(share * a);
    BOOST_TEST(tolerance::relative_difference(fall, std::copysign(slope, share)) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(the_gap_has_the_slope_of_equation_2) {
  // The rise of the gap between two points, by quadrature of a quadrature; the second and third
  // lie on both sides of ξ = 1.118, where the closed form takes over from the series.
  for (const double begin : {1.0137, 1.09, 1.12, 3.091}) {
    const double from = begin * a;
    const double to = (begin + 0.02385) * a;
    const double rise =
        numerics::Quadrature().smooth(slope_outside, from, to, 1e-15, {"rise", from}).value;
    BOOST_TEST(tolerance::relative_difference(wedge.gap(to) - wedge.gap(-from), rise) < 1e-11);
  }
}

BOOST_AUTO_TEST_CASE(the_gap_opens_from_the_edge) {
  // (2/π) a tan α (2√2/3) ε^{3/2} (1 + O(ε)), ε = ξ − 1
  const double x = a * (1 + 0x1p-40);
  const double expected =
      slope * a * (2 / pi) * (2 * std::numbers::sqrt2 / 3) * std::pow((x - a) / a, 1.5);

  BOOST_TEST(tolerance::relative_difference(wedge.gap(x), expected) < 1e-11);
  BOOST_TEST(wedge.gap(a) == 0);
  BOOST_TEST(wedge.gap(-0.3 * a) == 0);
}

BOOST_AUTO_TEST_CASE(far_off_the_gap_is_the_profile_less_a_logarithm) {
  // ξ arccos(1/ξ) − arcosh ξ = πξ/2 − 1 − ln 2ξ + O(1/ξ)
  const double xi = 2.385e7;
  const double expected = slope * a * (xi - (2 / pi) * (1 + std::log(2 * xi)));

  BOOST_TEST(tolerance::relative_difference(wedge.gap(xi * a), expected) < 1e-14);
}

BOOST_AUTO_TEST_CASE(half_width_and_pressure_scale_with_load_and_slope) {
  // A wedge has no length of its own: a is P/(E* tan α) and p a function of E* tan α and x/a.
  const Wedge steeper(modulus, 2.385 * slope, 7.31 * load);
  const double b = steeper.half_width();

  BOOST_TEST(tolerance::relative_difference(a, load / (modulus * slope)) < tolerance::rounding);
  BOOST_TEST(tolerance::relative_difference(b, a * 7.31 / 2.385) < tolerance::rounding);
  BOOST_TEST(tolerance::relative_difference(steeper.pressure(0.3137 * b),
                                            2.385 * wedge.pressure(0.3137 * a)) < 1e-14);
  BOOST_TEST(wedge.line_load() == load);
}

BOOST_AUTO_TEST_CASE(pressure_is_infinite_under_the_apex_and_zero_from_the_edge_on) {
  BOOST_TEST(wedge.pressure(0) == std::numeric_limits<double>::infinity());
  BOOST_TEST(std::isfinite(wedge.pressure(-1e-290 * a)));
  BOOST_TEST(wedge.pressure(a) == 0);
  BOOST_TEST(wedge.pressure(-2 * a) == 0);
}

BOOST_AUTO_TEST_CASE(inputs_must_be_positive) {
  BOOST_CHECK_THROW(Wedge(0, slope, load), InvalidQuantity);
  BOOST_CHECK_THROW(Wedge(modulus, -slope, load), InvalidQuantity);
  BOOST_CHECK_THROW(Wedge(modulus, slope, 0), InvalidQuantity);
  BOOST_CHECK_THROW(Wedge(modulus, slope, std::nan("")), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
