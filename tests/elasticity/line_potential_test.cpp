// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/line_potential.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "multiprecision.hpp"
#include "numbers.hpp"

BOOST_AUTO_TEST_SUITE(line_potential_test)

namespace {

Precise precise_triangle(const Precise& xi) {
  return precise_displacement_bracket(xi) / 2 - Precise(3) / 2;
}

Precise precise_strip(const Precise& xi) {
  const Precise half = Precise(1) / 2;
  return power_log(xi + half, 1) - power_log(xi - half, 1) - 1;
}

double relative(double found, const Precise& exact) {
  return abs((found - exact) / exact).toDouble();
}

// Every whole number to 40, across the change to a series at 16, and some up to 1e9.
std::vector<double> whole_numbers() {
  std::vector<double> numbers;
  for (int k = 0; k <= 40; ++k) numbers.push_back(k);
  RandomInputs random(2385);
  for (int i = 0; i < 200; ++i) numbers.push_back(std::floor(random.log_uniform(40, 1e9)));
  return numbers;
}

}  // namespace

BOOST_AUTO_TEST_CASE(potentials_have_fourteen_digits_at_whole_numbers) {
  for (const double k : whole_numbers()) {
    BOOST_TEST_CONTEXT("k = " << k) {
      BOOST_TEST(relative(elasticity::triangle_potential(k), precise_triangle(k)) < 1e-14);
      BOOST_TEST(relative(elasticity::strip_potential(k), precise_strip(k)) < 1e-14);
      BOOST_TEST(elasticity::triangle_potential(-k) == elasticity::triangle_potential(k));
      BOOST_TEST(elasticity::strip_potential(-k) == elasticity::strip_potential(k));
    }
  }
}

BOOST_AUTO_TEST_CASE(rises_from_one_whole_number_to_the_next_have_fourteen_digits) {
  for (const double k : whole_numbers()) {
    const Precise next = Precise(k) + 1;
    BOOST_TEST_CONTEXT("k = " << k) {
      BOOST_TEST(relative(elasticity::triangle_rise(k),
                          precise_triangle(next) - precise_triangle(k)) < 1e-14);
      BOOST_TEST(relative(elasticity::strip_rise(k), precise_strip(next) - precise_strip(k)) <
                 1e-14);
    }
  }
}

BOOST_AUTO_TEST_CASE(potentials_are_accurate_to_a_few_roundings_of_the_greatest_term_anywhere) {
  RandomInputs random(12);
  for (int i = 0; i < 20000; ++i) {
    const double xi = random.point(1e9);
    const double scale = std::max(1.0, std::log(std::abs(xi) + 1));
    const Precise triangle = elasticity::triangle_potential(xi) - precise_triangle(xi);
    const Precise strip = elasticity::strip_potential(xi) - precise_strip(xi);
    BOOST_TEST_CONTEXT("xi = " << xi) {
      BOOST_TEST(abs(triangle).toDouble() < 4e-15 * scale);
      BOOST_TEST(abs(strip).toDouble() < 4e-15 * scale);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_gradient_of_a_triangle_has_fourteen_digits_even_beside_its_kinks) {
  RandomInputs random(11);
  for (int i = 0; i < 20000; ++i) {
    const double xi = random.point(1e9);
    if (xi == 0) continue;
    BOOST_TEST_CONTEXT("xi = " << xi) {
      BOOST_TEST(relative(elasticity::triangle_gradient(xi), precise_gradient_bracket(xi)) < 1e-14);
    }
  }
  BOOST_TEST(elasticity::triangle_gradient(0) == 0);
  BOOST_TEST(tolerance::relative_difference(elasticity::triangle_gradient(1), 2 * std::log(2.0)) <
             tolerance::rounding);
}

BOOST_AUTO_TEST_CASE(all_functions_hold_up_to_where_squares_overflow) {
  for (const double xi : {1e9, 1e100, 1e200, 1e290}) {
    const double logarithm = std::log(xi);
    BOOST_TEST(tolerance::relative_difference(elasticity::triangle_potential(xi), logarithm) <
               1e-15);
    BOOST_TEST(tolerance::relative_difference(elasticity::strip_potential(xi), logarithm) < 1e-15);
    BOOST_TEST(tolerance::relative_difference(elasticity::triangle_gradient(xi), 1 / xi) < 1e-15);
  }
}

BOOST_AUTO_TEST_SUITE_END()
