// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/rounded_punch.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "line_contact/cauchy_integral.hpp"
#include "line_contact/cylinders.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(rounded_punch_test)

using line_contact::RoundedPunch;
using std::numbers::pi;
using sys::InvalidQuantity;

namespace {

constexpr double modulus = 913.7;
constexpr double b = 0.2385;
constexpr double curvature = 2.417;

// Loads at which (a−b)/b is 0.007, 0.03, 0.6 and 11.
constexpr double loads[] = {0.07317, 0.7317, 73.17, 12345.6};

// The kinks of p are at the edges of the flat.
double cauchy(const RoundedPunch& contact, double x) {
  return cauchy_integral([&](double s) { return contact.pressure(s); }, contact.half_width(), x, b);
}

double fall(const RoundedPunch& contact, double x) {
  return 2 / (pi * modulus) * cauchy(contact, x);
}

double profile_slope(double x) {
  return std::copysign(curvature * std::max(0.0, std::abs(x) - b), x);
}

// At ±b p has the infinite slope of t ln t: what the quadratures then reach.
constexpr double beside_kinks = 1e-11;

}  // namespace

BOOST_AUTO_TEST_CASE(pressure_integrates_to_the_load) {
  for (const double load : loads) {
    const RoundedPunch contact(modulus, b, curvature, load);
    // Far off, x ∫ p/(x−s) ds → P, to (a/x)²/2.
    const double far = 2.385e7 * contact.half_width();
    BOOST_TEST(tolerance::relative_difference(far * cauchy(contact, far), load) < beside_kinks);
    BOOST_TEST(contact.line_load() == load);
  }
}

BOOST_AUTO_TEST_CASE(pressure_closes_the_gap_by_equation_1a) {
  for (const double load : loads) {
    const RoundedPunch contact(modulus, b, curvature, load);
    const double a = contact.half_width();
    const double edge = a - b;
    for (const double x : {-0.947 * b, -0.313 * b, 0.01234 * b, 0.7713 * b, b + 0.1234 * edge,
                           -b - 0.6137 * edge, b + 0.947 * edge}) {
      // relative to what each side of the principal value is of
      const double scale = 2 / modulus * load / a;
      BOOST_TEST(std::abs(fall(contact, x) - profile_slope(x)) < beside_kinks * scale);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_gap_has_the_slope_of_equation_2) {
  for (const double load : loads) {
    const RoundedPunch contact(modulus, b, curvature, load);
    const auto slope = [&](double x) { return profile_slope(x) - fall(contact, x); };
    for (const double begin : {1.0137, 1.573, 3.091}) {
      const double from = begin * contact.half_width();
      const double to = 1.2385 * from;
      const double scale = profile_slope(to) * to + load / modulus;
      const double rise =
          numerics::Quadrature().smooth(slope, from, to, 1e-12 * scale, {"rise", from}).value;
      const double difference = contact.gap(to) - contact.gap(-from) - rise;
      BOOST_TEST(std::abs(difference) < beside_kinks * scale);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_gap_opens_from_the_edge) {
  for (const double load : loads) {
    const RoundedPunch contact(modulus, b, curvature, load);
    const double a = contact.half_width();
    BOOST_TEST(contact.gap(a) == 0);
    BOOST_TEST(contact.gap(-0.7 * b) == 0);
    // (2κ/π) ψ R³/(3a) to a part in R²/(a²−b²), but for the rounding of both sides' differences
    const double x = a * (1 + 1e-6);
    const double R = std::sqrt((x - a) * (x + a));
    const double expected = 2 * curvature / pi * std::acos(b / a) * R * R * R / (3 * a);
    BOOST_TEST(std::abs(contact.gap(x) - expected) < 3e-4 * expected + 1e-15 * load / modulus);
  }
}

BOOST_AUTO_TEST_CASE(the_gap_is_never_negative_beside_the_edge) {
  int n_negative = 0;
  for (double load = 1e-6; load < 1e6; load *= 1.2385) {
    const RoundedPunch contact(modulus, b, curvature, load);
    double x = contact.half_width();
    for (int i = 0; i < 8; ++i) {
      x = std::nextafter(x, 2 * x);
      if (!(contact.gap(x) >= 0)) ++n_negative;
    }
  }

  BOOST_TEST(n_negative == 0);
}

BOOST_AUTO_TEST_CASE(numbers_agree_with_sixty_digits) {
  // p in Ciavarella, Hills and Monno's form, ψ r + (x/2) ln|(xw+br)/(xw−br)| − (b/2)
  // ln|(w+r)/(w−r)| times E*κ/π, and the gap's formula, with mpmath 1.3.0 at 60 digits for E* =
  // 913.7, κ = 2.417.
  struct Reference {
    double flat, load, half_width, overhang;
    std::vector<std::pair<double, double>> pressure, gap;
  };
  const Reference references[] = {
      {0.2385,
       7.317e-10,
       0.23850000803014207,
       8.0301420791942239e-9,
       {{0.0173, 9.7912996577269594e-10},
        {0.1837, 1.5312065106354801e-9},
        {0.2385, 5.6448659681502981e-6}},
       {{0.2386, 1.2084985237680497e-8}, {1.37, 1.5472331841237595}}},
      {0.2385,
       0.7317,
       0.24646851084273802,
       0.0079685108427380342,
       {{0.0173, 0.95981899575449016}, {0.1837, 1.460849857065055}, {0.2385, 5.6323232929162933}},
       {{0.2713, 0.0010579429079143295}, {1.37, 1.5460027492404211}}},
      {0.2385,
       731.7,
       0.8161637481142655,
       0.57766374811426551,
       {{0.0173, 412.5640077122876}, {0.2385, 492.90596782275515}, {0.6137, 458.46381244510794}},
       {{1.137, 0.33096734186145992}, {13.7, 217.03618168898364}}},
      {2.385e-10,
       731.7,
       0.64950343055279229,
       0.64950343031429229,
       {{0.0173, 716.93142328788592}, {0.6137, 234.8276588370004}},
       {{1.137, 0.69133893943812687}}},
  };
  for (const auto& [flat, load, half_width, overhang, pressure, gap] : references) {
    const RoundedPunch contact(modulus, flat, curvature, load);
    BOOST_TEST(tolerance::relative_difference(contact.half_width(), half_width) < 1e-15);
    BOOST_TEST(tolerance::relative_difference(contact.overhang(), overhang) < 1e-14);
    for (const auto& [x, p] : pressure) {
      BOOST_TEST(tolerance::relative_difference(contact.pressure(-x), p) < 2e-14);
    }
    for (const auto& [x, rise] : gap) {
      const double scale = curvature * (x - flat) * (x - flat) / 2 + load / modulus;
      BOOST_TEST(std::abs(contact.gap(-x) - rise) < 1e-15 * scale);
    }
  }
}

BOOST_AUTO_TEST_CASE(without_a_flat_it_is_hertz) {
  using line_contact::Radius;
  const elasticity::Material rubber(700, 0.48);
  const line_contact::CylinderPair cylinders(rubber, Radius::of_cylinder("radius1", 1.137), rubber,
                                             Radius::of_cylinder("radius2", -2.385));
  const line_contact::Hertz hertz(cylinders, 3.461);
  const double a = hertz.half_width();
  // b = 0, and b = 1e-18 a, whose edges do not show
  for (const double flat : {0.0, 1e-18 * a}) {
    const RoundedPunch same(cylinders.contact_modulus(), flat, cylinders.relative_curvature(),
                            3.461);
    BOOST_TEST(tolerance::relative_difference(same.half_width(), a) < tolerance::rounding);
    BOOST_TEST(tolerance::relative_difference(same.peak_pressure(), hertz.peak_pressure()) < 1e-14);
    for (const double x : {0.0, 0.3137 * a, -0.9713 * a}) {
      BOOST_TEST(tolerance::relative_difference(same.pressure(x), hertz.pressure(x)) < 1e-14);
    }
    for (const double x : {1.3137 * a, -9.713 * a}) {
      BOOST_TEST(tolerance::relative_difference(same.gap(x), hertz.gap(x)) < 1e-14);
    }
  }
}

BOOST_AUTO_TEST_CASE(under_a_light_load_it_is_the_flat_punch) {
  // to a part of the order of (a−b)/b = 2e-9
  const double load = 1.137e-11;
  const RoundedPunch contact(modulus, b, curvature, load);

  for (const double x : {0.0, 0.3137 * b, -0.8713 * b}) {
    const double flat = load / (pi * std::sqrt((b - x) * (b + x)));  // Johnson 2.64
    BOOST_TEST(tolerance::relative_difference(contact.pressure(x), flat) < 1e-8);
  }
}

BOOST_AUTO_TEST_CASE(pressure_is_continuous_at_the_ends_of_the_flat) {
  // (E*κ/π) [ψw − b ln(a/b)] there; t ln t for t = 1e-16 b beside it is less than 1e-11 of this.
  for (const double load : loads) {
    const RoundedPunch contact(modulus, b, curvature, load);
    const double a = contact.half_width();
    const double w = std::sqrt((a - b) * (a + b));
    const double expected = modulus * curvature / pi * (std::acos(b / a) * w - b * std::log(a / b));
    for (const double x : {b, std::nextafter(b, 0), std::nextafter(b, 1), -b}) {
      BOOST_TEST(tolerance::relative_difference(contact.pressure(x), expected) < 1e-11);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_peak_is_the_largest_pressure) {
  constexpr int n_points = 20000;
  for (const double load : loads) {
    const RoundedPunch contact(modulus, b, curvature, load);
    double largest = 0;
    for (int i = 0; i < n_points; ++i) {
      largest = std::max(largest, contact.pressure(b + (contact.half_width() - b) * i / n_points));
    }
    BOOST_TEST(contact.peak_pressure() >= largest * (1 - tolerance::rounding));
    BOOST_TEST(contact.peak_pressure() > contact.pressure(b) * 1.00001);
    // the points miss it by p'' step²/8, with p'' of the order of 1/(x−b)
    BOOST_TEST(tolerance::relative_difference(largest, contact.peak_pressure()) < 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(pressure_is_zero_from_the_edge_on) {
  for (const double load : loads) {
    const RoundedPunch contact(modulus, b, curvature, load);
    const double a = contact.half_width();
    BOOST_TEST(contact.pressure(a) == 0);
    BOOST_TEST(contact.pressure(-2.385 * a) == 0);
    BOOST_TEST(contact.pressure(std::nextafter(a, 0)) > 0);
  }
}

BOOST_AUTO_TEST_CASE(the_edge_curvature_for_a_half_width_gives_that_half_width) {
  for (const double ratio : {1.03, 1.7, 23.85}) {
    const double kappa = RoundedPunch::edge_curvature_for(modulus, b, ratio * b, 73.17);
    const RoundedPunch contact(modulus, b, kappa, 73.17);
    BOOST_TEST(tolerance::relative_difference(contact.half_width(), ratio * b) < 1e-13);
  }
  BOOST_CHECK_THROW(RoundedPunch::edge_curvature_for(modulus, b, b, 73.17), InvalidQuantity);
  BOOST_CHECK_THROW(RoundedPunch::edge_curvature_for(modulus, b, NAN, 73.17), InvalidQuantity);
}

BOOST_AUTO_TEST_CASE(inputs_outside_their_range_are_refused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_THROW(RoundedPunch(0, b, curvature, 73.17), InvalidQuantity);
  BOOST_CHECK_THROW(RoundedPunch(modulus, -1e-9, curvature, 73.17), InvalidQuantity);
  BOOST_CHECK_THROW(RoundedPunch(modulus, nan, curvature, 73.17), InvalidQuantity);
  BOOST_CHECK_THROW(RoundedPunch(modulus, b, 0, 73.17), InvalidQuantity);
  BOOST_CHECK_THROW(RoundedPunch(modulus, b, curvature, 0), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
