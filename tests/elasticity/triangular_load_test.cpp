// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/triangular_load.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "elasticity/concentrated_load.hpp"
#include "multiprecision.hpp"
#include "random_inputs.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(triangular_load_test)

using elasticity::Load;
using elasticity::Material;
using elasticity::normal_displacement;
using elasticity::normal_gradient;
using elasticity::TriangularLoad;
using sys::InvalidQuantity;
using tolerance::relative_difference;

namespace {

const Material steel(30e6, 0.3);
const TriangularLoad load(1000, 0.01);
constexpr double datum = 10;

double gradient_unit(const Material& material, const TriangularLoad& triangle) {  // K/a
  return material.integral_compliance() * triangle.peak_pressure();
}

}  // namespace

BOOST_AUTO_TEST_CASE(gradient_is_right_to_1e_13_from_the_centre_to_1e9_half_widths) {
  RandomInputs random(11);
  for (int i = 0; i < 20000; ++i) {
    const double a = random.log_uniform(1e-6, 1e3);
    const TriangularLoad triangle(2.385, a);
    const double x = a * random.point(1e9);
    if (x == 0) continue;
    const Precise exact =
        -gradient_unit(steel, triangle) * precise_gradient_bracket(Precise(x) / Precise(a));
    const double error = abs((normal_gradient(steel, triangle, x) - exact) / exact).toDouble();
    BOOST_TEST_CONTEXT("x/a = " << x / a) {
      BOOST_TEST(error < tolerance::gradient);
    }
  }
}

BOOST_AUTO_TEST_CASE(displacement_is_right_to_1e_14_of_its_scale_to_1e9_half_widths) {
  RandomInputs random(12);
  for (int i = 0; i < 20000; ++i) {
    const double a = random.log_uniform(1e-6, 1e3);
    const TriangularLoad triangle(2.385, a);
    const double zero_at = a * random.log_uniform(1, 1e9);
    const double x = a * random.point(1e9);
    const double unit = gradient_unit(steel, triangle) * a;  // K
    const Precise exact =
        -(unit / 2) * (precise_displacement_bracket(Precise(x) / Precise(a)) -
                       precise_displacement_bracket(Precise(zero_at) / Precise(a)));
    const Precise difference = normal_displacement(steel, triangle, x, zero_at) - exact;
    // As stated for |x| up to the datum; beyond it ln(|x|/a) is the scale.
    const double scale = unit * (1 + std::log(std::max(zero_at, std::abs(x)) / a));
    BOOST_TEST_CONTEXT("x/a = " << x / a << ", datum/a = " << zero_at / a) {
      BOOST_TEST(abs(difference).toDouble() < tolerance::displacement * scale);
    }
  }
}

BOOST_AUTO_TEST_CASE(gradient_at_the_kinks_is_the_limit) {
  // ∓(K/a) 2 ln 2 at x = ±a, 0 at x = 0.
  const double at_end = -gradient_unit(steel, load) * 2 * std::log(2.0);

  BOOST_TEST(normal_gradient(steel, load, 0) == 0);
  BOOST_TEST(relative_difference(normal_gradient(steel, load, 0.01), at_end) < 1e-15);
  BOOST_TEST(relative_difference(normal_gradient(steel, load, -0.01), -at_end) < 1e-15);
}

BOOST_AUTO_TEST_CASE(displacement_at_the_kinks_is_the_limit) {
  // u(0) − u(a) = (K/2)(4 ln 2) and u(datum) = 0
  const double unit = gradient_unit(steel, load) * 0.01;
  const double drop =
      normal_displacement(steel, load, 0, datum) - normal_displacement(steel, load, 0.01, datum);

  BOOST_TEST(relative_difference(drop, unit / 2 * 4 * std::log(2.0)) < 1e-14);
  BOOST_TEST(normal_displacement(steel, load, datum, datum) == 0);
}

BOOST_AUTO_TEST_CASE(displacement_is_even_and_its_gradient_odd) {
  RandomInputs random(13);
  for (int i = 0; i < 200; ++i) {
    const double x = 0.01 * random.point(1e6);
    BOOST_TEST(normal_displacement(steel, load, x, datum) ==
               normal_displacement(steel, load, -x, datum));
    BOOST_TEST(normal_gradient(steel, load, x) == -normal_gradient(steel, load, -x));
  }
}

BOOST_AUTO_TEST_CASE(gradient_is_the_derivative_of_the_displacement) {
  // Central differences lose a third of the digits: the truncation error is of order h².
  for (const double x : {0.0023, 0.0077, 0.0131, 0.05, 1.3}) {
    const double h = 1e-5 * x;
    const double difference = (normal_displacement(steel, load, x + h, datum) -
                               normal_displacement(steel, load, x - h, datum)) /
                              (2 * h);
    BOOST_TEST(relative_difference(difference, normal_gradient(steel, load, x)) < 1e-8);
  }
}

BOOST_AUTO_TEST_CASE(far_away_only_the_resultant_counts) {
  // The next term of the far field is (a/x)²/6 of the first.
  const elasticity::ConcentratedLoad same_resultant(load.line_load());
  for (const double ratio : {10.0, 1e2, 1e3}) {
    const double x = ratio * 0.01;
    const double difference = relative_difference(normal_gradient(steel, load, x),
                                                  normal_gradient(steel, same_resultant, x));
    BOOST_TEST(std::abs(difference * ratio * ratio * 6 - 1) < 0.01);
  }
}

BOOST_AUTO_TEST_CASE(the_closed_forms_hold_out_to_where_squares_overflow) {
  const elasticity::ConcentratedLoad same_resultant(load.line_load());
  for (const double x : {1e9, 1e100, -1e200, 1e290}) {
    BOOST_TEST(relative_difference(normal_gradient(steel, load, x),
                                   normal_gradient(steel, same_resultant, x)) < 1e-15);
    // Between two points that far away the force is concentrated too.
    const double fall = normal_displacement(steel, load, x, 1e12);
    BOOST_TEST(relative_difference(fall, normal_displacement(steel, same_resultant, x, 1e12)) <
               1e-14);
  }
}

BOOST_AUTO_TEST_CASE(displacement_prints_the_digits_of_the_paper) {
  // Ruggiero (2001), Appendix 1, output of Tri_dist.m, eight digits; the third value was taken 1e-7
  // in beside x = 0.010 in and is left out.
  constexpr std::array<double, 11> printed = {1.6236048e-6, 1.5187874e-6, 0,
                                              1.2635610e-6, 1.2043351e-6, 1.1596620e-6,
                                              1.1236214e-6, 1.0933600e-6, 1.0672569e-6,
                                              1.0442961e-6, 1.0237964e-6};
  for (std::size_t i = 0; i < printed.size(); ++i) {
    if (i == 2) continue;
    const double x = 0.005 * static_cast<double>(i);
    BOOST_TEST(std::abs(normal_displacement(steel, load, x, datum) - printed[i]) < 0.5e-13);
  }
}

BOOST_AUTO_TEST_CASE(potential_is_minus_three_halves_at_the_centre_and_a_logarithm_far_away) {
  BOOST_TEST(elasticity::triangular_potential(0, 2.385) == -1.5);
  const double far = elasticity::triangular_potential(2.385e7, 2.385);
  BOOST_TEST(relative_difference(far, std::log(1e7)) < 1e-14);
}

BOOST_AUTO_TEST_CASE(tangential_displacement_is_constant_outside_the_load) {
  const double expected = steel.local_compliance() / 2 * load.line_load();

  for (const double x : {0.01, 0.02, 5.0}) {
    BOOST_TEST(relative_difference(tangential_displacement(steel, load, x), -expected) < 1e-15);
    BOOST_TEST(relative_difference(tangential_displacement(steel, load, -x), expected) < 1e-15);
  }
  BOOST_TEST(tangential_displacement(steel, load, 0) == 0);
}

BOOST_AUTO_TEST_CASE(tangential_gradient_is_the_local_compliance_times_the_pressure) {
  const Load general = load;
  for (const double x : {-0.007, 0.0, 0.0023, 0.01, 0.3}) {
    const double expected = -steel.local_compliance() * general.normal(x);
    BOOST_TEST(std::abs(tangential_gradient(steel, load, x) - expected) < 1e-20);
  }
}

BOOST_AUTO_TEST_CASE(the_load_is_p0_in_the_middle_and_zero_at_its_ends) {
  const Load general = load;

  BOOST_TEST(general.normal(0) == 1000);
  BOOST_TEST(relative_difference(general.normal(-0.0025), 750) < 1e-15);
  BOOST_TEST(general.normal(0.01) == 0);
  BOOST_TEST(load.line_load() == 10);
}

BOOST_AUTO_TEST_CASE(sizes_and_points_that_make_no_sense_are_refused) {
  const double infinity = std::numeric_limits<double>::infinity();

  BOOST_CHECK_THROW(TriangularLoad(0, 1), InvalidQuantity);
  BOOST_CHECK_THROW(TriangularLoad(1, -1), InvalidQuantity);
  BOOST_CHECK_THROW(TriangularLoad(NAN, 1), InvalidQuantity);
  BOOST_CHECK_THROW(normal_gradient(steel, load, infinity), InvalidQuantity);
  BOOST_CHECK_THROW(normal_displacement(steel, load, NAN, datum), InvalidQuantity);
  BOOST_CHECK_THROW(normal_displacement(steel, load, 0, infinity), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
