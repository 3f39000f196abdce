// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/linear_potential.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "elasticity/triangular_load.hpp"
#include "multiprecision.hpp"
#include "numerics/kernel_integrals.hpp"
#include "random_inputs.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(linear_potential_test)

using elasticity::element_potential;
using elasticity::ElementPotential;
using tolerance::relative_difference;

namespace {

struct PreciseElementPotential {
  Precise begin, end, middle;
};

// ∫ uᵏ ln|u| du from the antiderivatives as they stand: a hundred digits leave room for their
// cancellation, which is (far/ℓ)³ at most.
Precise power_moment(const Precise& begin, const Precise& end, int k) {
  const auto antiderivative = [k](const Precise& u) -> Precise {
    return power_log(u, k + 1) / (k + 1) - pow(u, k + 1) / ((k + 1) * (k + 1));
  };
  return antiderivative(end) - antiderivative(begin);
}

PreciseElementPotential precise_potential(double begin, double end) {
  const Precise b = begin;
  const Precise e = end;
  const Precise length = e - b;
  const Precise m0 = power_moment(b, e, 0);
  const Precise m1 = power_moment(b, e, 1);
  const Precise m2 = power_moment(b, e, 2);
  return {(e * m0 - m1) / length, (m1 - b * m0) / length,
          4 * ((b + e) * m1 - m2 - b * e * m0) / (length * length)};
}

double far_logarithm(double begin, double end) {
  const double far = std::max(std::abs(begin), std::abs(end));
  return std::max({1.0, std::abs(std::log(far)), std::abs(std::log((end - begin) / 2))});
}

double error(double value, const Precise& exact) {
  return abs(value - exact).toDouble();
}

}  // namespace

BOOST_AUTO_TEST_CASE(potentials_are_right_to_2e_15_from_the_element_to_1e9_half_lengths) {
  constexpr double promised = 2e-15;
  RandomInputs random(51);
  for (int i = 0; i < 20000; ++i) {
    const double half_length = random.log_uniform(1e-12, 1e3);
    const double centre = half_length * random.point(1e9);
    const double begin = centre - half_length;
    const double end = centre + half_length;
    const ElementPotential potential = element_potential(begin, end);
    const PreciseElementPotential exact = precise_potential(begin, end);
    const double bound = promised * (end - begin) / 2 * far_logarithm(begin, end);
    BOOST_TEST_CONTEXT("z = " << centre / half_length << ", length = " << end - begin) {
      BOOST_TEST(error(potential.begin, exact.begin) < bound);
      BOOST_TEST(error(potential.end, exact.end) < bound);
      BOOST_TEST(error(potential.middle, exact.middle) < bound);
    }
  }
}

BOOST_AUTO_TEST_CASE(what_two_neighbours_differ_in_far_away_is_not_lost) {
  // end − begin = ∫ τ ln|u| du: a slope's own potential, a small difference of the two. Relative to
  // it the error grows only with the distance, as the rounding of the two does.
  for (const double distance : {2.1, 7.3, 1e3, 1e7}) {
    const ElementPotential potential = element_potential(distance - 1, distance + 1);
    const PreciseElementPotential exact = precise_potential(distance - 1, distance + 1);
    const Precise slope = exact.end - exact.begin;
    BOOST_TEST(error((potential.end - potential.begin), slope) <
               tolerance::rounding * (1 + std::log(distance)));
    BOOST_TEST(relative_difference(slope.toDouble() * distance, 2.0 / 3) < 0.2);
  }
}

BOOST_AUTO_TEST_CASE(closed_form_and_series_meet) {
  const double below = std::nextafter(3.0, 0.0);
  const double above = std::nextafter(3.0, 4.0);
  for (const double sign : {-1.0, 1.0}) {
    const auto at = [sign](double far) {
      return sign > 0 ? element_potential(1, far) : element_potential(-far, -1);
    };
    BOOST_TEST(std::abs(at(below).begin - at(above).begin) < tolerance::rounding);
    BOOST_TEST(std::abs(at(below).end - at(above).end) < tolerance::rounding);
    BOOST_TEST(std::abs(at(below).middle - at(above).middle) < tolerance::rounding);
  }
}

BOOST_AUTO_TEST_CASE(two_equal_elements_are_the_triangle_of_equation_3) {
  const double a = 2.385;
  for (const double x : {0.0, 0.7, -2.385, 3.1, -11.0, 40.0}) {
    const double hat = element_potential(-a - x, -x).end + element_potential(-x, a - x).begin;
    const double triangle = a * (elasticity::triangular_potential(x, a) + std::log(a));
    BOOST_TEST(std::abs(hat - triangle) < 4 * tolerance::rounding * std::abs(triangle));
  }
}

BOOST_AUTO_TEST_CASE(an_unequal_hat_is_its_integral_by_quadrature) {
  // On [−0.7, 0.2, 2.385]; in, at the kinks of and outside the hat.
  const numerics::PiecewiseFunction hat({
      {-0.7, 0.2, [](double s) { return (s + 0.7) / 0.9; }},
      {0.2, 2.385, [](double s) { return (2.385 - s) / 2.185; }},
  });
  const numerics::KernelIntegrals integrals(hat);
  for (const double x : {-3.1, -0.7, 0.1, 0.2, 0.9, 2.385, 40.0}) {
    const double closed =
        element_potential(-0.7 - x, 0.2 - x).end + element_potential(0.2 - x, 2.385 - x).begin;
    const numerics::Estimate exact = integrals.logarithmic(x, 1);
    BOOST_TEST(std::abs(closed - exact.value) < exact.abs_error + tolerance::quadrature);
  }
}

BOOST_AUTO_TEST_CASE(the_parabola_is_its_integral_by_quadrature) {
  const numerics::KernelIntegrals integrals(numerics::PiecewiseFunction(
      {{0.3, 2.7, [](double s) { return (s - 0.3) * (2.7 - s) / 1.44; }}}));
  for (const double x : {-7.0, 0.3, 1.1, 2.7, 4.0}) {
    const double closed = element_potential(0.3 - x, 2.7 - x).middle;
    const numerics::Estimate exact = integrals.logarithmic(x, 1);
    BOOST_TEST(std::abs(closed - exact.value) < exact.abs_error + tolerance::quadrature);
  }
}

BOOST_AUTO_TEST_CASE(seen_from_the_other_side_begin_and_end_change_places) {
  for (const double begin : {-0.4, -1.0, 0.0, 0.6, 9.0}) {
    const ElementPotential there = element_potential(begin, begin + 1.3);
    const ElementPotential back = element_potential(-begin - 1.3, -begin);
    BOOST_TEST(std::abs(there.begin - back.end) < tolerance::rounding);
    BOOST_TEST(std::abs(there.end - back.begin) < tolerance::rounding);
    BOOST_TEST(std::abs(there.middle - back.middle) < tolerance::rounding);
  }
}

BOOST_AUTO_TEST_CASE(at_its_ends_the_potential_is_the_limit) {
  // ∫₀¹ (1−u) ln u du = −3/4, ∫₀¹ u ln u du = −1/4, ∫₀¹ 4u(1−u) ln u du = −5/9
  const ElementPotential potential = element_potential(0, 1);

  BOOST_TEST(relative_difference(potential.begin, -0.75) < tolerance::rounding);
  BOOST_TEST(relative_difference(potential.end, -0.25) < tolerance::rounding);
  BOOST_TEST(relative_difference(potential.middle, -5.0 / 9) < tolerance::rounding);
}

BOOST_AUTO_TEST_SUITE_END()
