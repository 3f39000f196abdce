// SPDX-License-Identifier: GPL-3.0-or-later
// References are the unchanged formulas in a hundred digits: of 1e9² ln 1e9
// about eighty remain.
#include "line_contact/element.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "multiprecision.hpp"
#include "numbers.hpp"

BOOST_AUTO_TEST_SUITE(element_test)

using Eigen::Index;
using line_contact::Element;
using line_contact::influence_coefficient;
using line_contact::influence_difference;

namespace {

constexpr Element elements[] = {Element::point, Element::uniform, Element::triangular};

// T(k), except for the point's own value T(0).
Precise precise_coefficient(Element element, const Precise& k) {
  const Precise half = Precise(1) / 2;
  switch (element) {
    case Element::triangular:
      return precise_displacement_bracket(k) / 2 - Precise(3) / 2;
    case Element::uniform:
      return power_log(k + half, 1) - power_log(k - half, 1) - 1;
    case Element::point:
      break;
  }
  if (k == 0) return -log(2 * mpfr::const_pi());
  return log(abs(k));
}

// Every whole number to 40, across the change to a series at 16, and some up to 1e9.
std::vector<Index> whole_numbers() {
  std::vector<Index> k;
  for (Index i = 0; i <= 40; ++i) k.push_back(i);
  RandomInputs random(2385);
  for (int i = 0; i < 200; ++i) k.push_back(std::lround(random.log_uniform(40, 1e9)));
  k.push_back(1'000'000'000);
  return k;
}

double relative_error(double value, const Precise& exact) {
  if (exact == 0) return std::abs(value);
  return static_cast<double>(abs((value - exact) / exact));
}

}  // namespace

BOOST_AUTO_TEST_CASE(coefficients_are_accurate_to_1e_14_relative) {
  for (const Element element : elements) {
    for (const Index k : whole_numbers()) {
      BOOST_TEST_CONTEXT(name_of(element) << ", k = " << k) {
        const double coefficient = influence_coefficient(element, static_cast<double>(k));
        BOOST_TEST(relative_error(coefficient, precise_coefficient(element, k)) < 1e-14);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(differences_are_accurate_to_1e_14_relative) {
  for (const Element element : elements) {
    for (const Index k : whole_numbers()) {
      BOOST_TEST_CONTEXT(name_of(element) << ", k = " << k) {
        const Precise exact = precise_coefficient(element, k + 1) - precise_coefficient(element, k);
        BOOST_TEST(relative_error(influence_difference(element, k), exact) < 1e-14);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(all_elements_act_as_a_force_far_away) {
  // T(k) − ln k = −⟨s²⟩/(2k²) + …, ⟨s²⟩ = 1/6, 1/12 and 0; the next term is less than 1/k⁴.
  const double k = 238.5;
  const auto beyond = [k](Element element) {
    return influence_coefficient(element, k) - std::log(k);
  };
  BOOST_TEST(std::abs(beyond(Element::triangular) + 1 / (12 * k * k)) < 1 / std::pow(k, 4));
  BOOST_TEST(std::abs(beyond(Element::uniform) + 1 / (24 * k * k)) < 1 / std::pow(k, 4));
  BOOST_TEST(beyond(Element::point) == 0);
}

namespace {

constexpr double at = 0.2385;

double smooth(double s) {
  const double t = (1 - s) * (1 + s);
  return t * t * t * t;
}

// ∫ (1−s²)⁴ ln|at − s| ds in closed form: ∫ sⁿ ln|x−s| ds by parts, in a hundred digits.
double smooth_potential() {
  const Precise x = at;
  const auto moment = [&](int n) {
    // ∫₋₁¹ sⁿ ln|x−s| ds = [s^{n+1} ln|x−s|/(n+1)] + 1/(n+1) ∫ s^{n+1}/(x−s) ds
    Precise remainder = 0;  // ∫₋₁¹ (s^{n+1} − x^{n+1})/(x−s) ds = −Σ x^{n−j} ∫ s^j ds
    for (int j = 0; j <= n; j += 2) remainder -= pow(x, n - j) * 2 / (j + 1);
    const Precise cauchy = pow(x, n + 1) * log((1 + x) / (1 - x)) + remainder;
    return (log(1 - x) + log(1 + x) + cauchy) / (n + 1);  // n even
  };
  return static_cast<double>(moment(0) - 4 * moment(2) + 6 * moment(4) - 4 * moment(6) + moment(8));
}

// The same by forces a distance c apart, one of them at the point.
double row_error(double c) {
  double sum = 0;
  double load = 0;
  for (Index k = -static_cast<Index>(3 / c); k <= static_cast<Index>(3 / c); ++k) {
    const double s = at + static_cast<double>(k) * c;
    if (std::abs(s) >= 1) continue;
    sum += c * smooth(s) * influence_coefficient(Element::point, static_cast<double>(k));
    load += c * smooth(s);
  }
  return sum + load * std::log(c) - smooth_potential();
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_row_of_forces_replaces_a_smooth_pressure_to_order_three) {
  // Sidi & Israeli (1988), theorem 4: the sum exceeds the integral by −ζ′(−2) p″ c³ + O(c⁵),
  // ζ′(−2) = −0.030448457058393270780 (N[Zeta'[-2], 20]).
  constexpr double zeta = -0.030448457058393270780;
  const double t = (1 - at) * (1 + at);
  const double second_derivative = -8 * t * t * t + 48 * at * at * t * t;

  for (const double c : {0.02385, 0.012, 0.006}) {
    const double leading = -zeta * second_derivative * c * c * c;
    BOOST_TEST(tolerance::relative_difference(row_error(c), leading) < 20 * c * c);
  }
}

BOOST_AUTO_TEST_SUITE_END()
