// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/power_law.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "line_contact/cauchy_integral.hpp"
#include "line_contact/cylinders.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(power_law_test)

using line_contact::PowerLaw;
using std::numbers::pi;
using sys::InvalidQuantity;

namespace {

constexpr double modulus = 913.7;
constexpr double coefficient = 0.7391;
constexpr double load = 3.461;
constexpr int powers[] = {1, 2, 3, 7, 20};

double cauchy(const PowerLaw& contact, double x) {
  return cauchy_integral([&](double s) { return contact.pressure(s); }, contact.half_width(), x);
}

double fall(const PowerLaw& contact, double x) {
  return 2 / (pi * modulus) * cauchy(contact, x);
}

// h' = 2n A x^{2n−1}
double profile_slope(int n, double x) {
  return 2 * n * coefficient * std::pow(x, 2 * n - 1);
}

}  // namespace

BOOST_AUTO_TEST_CASE(pressure_integrates_to_the_load) {
  for (const int n : powers) {
    const PowerLaw contact(modulus, coefficient, n, load);
    // Far off, x ∫ p/(x−s) ds → P, to (a/x)²/2.
    const double far = 2.385e7 * contact.half_width();
    BOOST_TEST(tolerance::relative_difference(far * cauchy(contact, far), load) < 1e-13);
    BOOST_TEST(contact.line_load() == load);
  }
}

BOOST_AUTO_TEST_CASE(pressure_closes_the_gap_by_equation_1a) {
  for (const int n : powers) {
    const PowerLaw contact(modulus, coefficient, n, load);
    const double a = contact.half_width();
    for (const double share : {-0.947, -0.313, 0.1234, 0.7713}) {
      // relative to the slope at the edge: within, h' is a small difference of the two sides
      const double difference = fall(contact, share * a) - profile_slope(n, share * a);
      BOOST_TEST(std::abs(difference) < 1e-12 * profile_slope(n, a));
    }
  }
}

BOOST_AUTO_TEST_CASE(the_gap_has_the_slope_of_equation_2) {
  for (const int n : powers) {
    const PowerLaw contact(modulus, coefficient, n, load);
    const auto slope = [&](double x) { return profile_slope(n, x) - fall(contact, x); };
    for (const double begin : {1.0137, 1.573, 3.091}) {
      const double from = begin * contact.half_width();
      const double to = 1.2385 * from;
      const double scale = coefficient * std::pow(to, 2 * n);
      const double rise =
          numerics::Quadrature().smooth(slope, from, to, 1e-13 * scale, {"rise", from}).value;
      // nested quadratures of h' less nearly as much
      BOOST_TEST(std::abs(contact.gap(to) - contact.gap(-from) - rise) < 1e-12 * scale);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_gap_opens_from_the_edge) {
  // Where p = k√ε, ε = 1 − |ξ|, the slope outside is (2/E*) k√ε, ε = |ξ| − 1, to a part in n²ε.
  constexpr double step = 0x1p-40;
  for (const int n : powers) {
    const PowerLaw contact(modulus, coefficient, n, load);
    const double a = contact.half_width();
    const double inside = a * (1 - step);
    const double outside = a * (1 + step);
    const double k = contact.pressure(inside) / std::sqrt((a - inside) / a);
    const double expected = 2 / modulus * k * a * (2.0 / 3) * std::pow((outside - a) / a, 1.5);
    BOOST_TEST(tolerance::relative_difference(contact.gap(outside), expected) < 1e-9);
    BOOST_TEST(contact.gap(a) == 0);
    BOOST_TEST(contact.gap(-0.3 * a) == 0);
  }
}

BOOST_AUTO_TEST_CASE(the_first_power_is_hertz) {
  using line_contact::Radius;
  const elasticity::Material rubber(700, 0.48);
  const line_contact::CylinderPair cylinders(rubber, Radius::of_cylinder("radius1", 1.137), rubber,
                                             Radius::of_cylinder("radius2", -2.385));
  const line_contact::Hertz hertz(cylinders, load);
  const PowerLaw same(cylinders.contact_modulus(), cylinders.relative_curvature() / 2, 1, load);
  const double a = hertz.half_width();

  BOOST_TEST(tolerance::relative_difference(same.half_width(), a) < tolerance::rounding);
  BOOST_TEST(tolerance::relative_difference(same.peak_pressure(), hertz.peak_pressure()) < 1e-14);
  for (const double x : {0.3137 * a, -0.9713 * a}) {
    BOOST_TEST(tolerance::relative_difference(same.pressure(x), hertz.pressure(x)) < 1e-14);
  }
  for (const double x : {1.3137 * a, -9.713 * a}) {
    BOOST_TEST(tolerance::relative_difference(same.gap(x), hertz.gap(x)) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(the_peak_is_the_largest_pressure) {
  constexpr int n_points = 2000;
  for (const int n : powers) {
    const PowerLaw contact(modulus, coefficient, n, load);
    double largest = 0;
    for (int i = 0; i < n_points; ++i) {
      largest = std::max(largest, contact.pressure(contact.half_width() * i / n_points));
    }
    BOOST_TEST(contact.peak_pressure() >= largest * (1 - tolerance::rounding));
    // the points miss it by p'' step²/8 at most, |p''| < 100 n² p/a²
    BOOST_TEST(tolerance::relative_difference(largest, contact.peak_pressure()) <
               13.0 * n * n / (n_points * n_points));
  }
}

BOOST_AUTO_TEST_CASE(the_peak_of_the_fourth_power_is_at_one_over_root_two) {
  const PowerLaw contact(modulus, coefficient, 2, load);
  const double c2 = 0.375;
  const double expected = load / (pi * c2 * contact.half_width() * std::numbers::sqrt2);

  BOOST_TEST(tolerance::relative_difference(contact.peak_pressure(), expected) < 1e-14);
}

BOOST_AUTO_TEST_CASE(pressure_is_zero_from_the_edge_on) {
  const PowerLaw contact(modulus, coefficient, 3, load);

  BOOST_TEST(contact.pressure(contact.half_width()) == 0);
  BOOST_TEST(contact.pressure(-2.385 * contact.half_width()) == 0);
}

BOOST_AUTO_TEST_CASE(the_coefficient_for_a_half_width_gives_that_half_width) {
  for (const int n : powers) {
    for (const double a : {0.02385, 1.7}) {
      const double A = PowerLaw::coefficient_for(modulus, n, a, load);
      BOOST_TEST(tolerance::relative_difference(PowerLaw(modulus, A, n, load).half_width(), a) <
                 1e-14);
    }
  }
  BOOST_CHECK_THROW(PowerLaw::coefficient_for(modulus, 2, 0, load), InvalidQuantity);
  BOOST_CHECK_THROW(PowerLaw::coefficient_for(modulus, 0, 1, load), InvalidQuantity);
}

BOOST_AUTO_TEST_CASE(inputs_outside_their_range_are_refused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_THROW(PowerLaw(0, coefficient, 2, load), InvalidQuantity);
  BOOST_CHECK_THROW(PowerLaw(modulus, -coefficient, 2, load), InvalidQuantity);
  BOOST_CHECK_THROW(PowerLaw(modulus, coefficient, 0, load), InvalidQuantity);
  BOOST_CHECK_THROW(PowerLaw(modulus, coefficient, 21, load), InvalidQuantity);
  BOOST_CHECK_THROW(PowerLaw(modulus, coefficient, 2, 0), InvalidQuantity);
  BOOST_CHECK_THROW(PowerLaw(modulus, coefficient, 2, nan), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
