// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/piecewise_linear_load.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "elasticity/load_shapes.hpp"
#include "elasticity/surface_quadrature.hpp"
#include "elasticity/triangular_load.hpp"
#include "multiprecision.hpp"
#include "numerics/kernel_integrals.hpp"
#include "random_inputs.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(piecewise_linear_load_test)

BOOST_AUTO_TEST_SUITE(linear_potential)

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

using elasticity::Material;
using elasticity::normal_displacement;
using elasticity::normal_gradient;
using elasticity::PiecewiseLinearLoad;
using elasticity::SurfaceQuadrature;
using elasticity::TriangularLoad;
using elasticity::UniformLoad;
using tolerance::relative_difference;

namespace {

const Material steel(207e3, 0.29);
// unequal elements, a stretch without load and one that pulls
const std::vector<double> positions{-0.71, -0.4, 0.03, 0.05, 0.31, 0.6, 1.9};
const std::vector<double> pressures{0, 2.385, 1.1, 0, 0, -0.4, 0};
const PiecewiseLinearLoad load(positions, pressures);
const double datum = 7.7;
const double unit = steel.integral_compliance() * 2.385;  // of the gradient

Precise exact_gradient(double x) {
  Precise sum = 0;
  for (std::size_t i = 0; i + 1 < positions.size(); ++i) {
    const Precise begin = positions[i];
    const Precise end = positions[i + 1];
    const Precise slope = (Precise(pressures[i + 1]) - pressures[i]) / (end - begin);
    const Precise here = pressures[i] + slope * (x - begin);
    sum += here * log(abs((x - begin) / (x - end))) - slope * (end - begin);
  }
  return -steel.integral_compliance() * sum;
}

// u_z but for a constant: ∫ (h + g t) ln|t| dt = h (t ln|t| − t) + g (t² ln|t|/2 − t²/4), t = s −
// x.
Precise exact_displacement(double x) {
  const auto integral = [](const Precise& h, const Precise& g, const Precise& t) -> Precise {
    return h * (power_log(t, 1) - t) + g * (power_log(t, 2) / 2 - t * t / 4);
  };
  Precise sum = 0;
  for (std::size_t i = 0; i + 1 < positions.size(); ++i) {
    const Precise begin = positions[i];
    const Precise end = positions[i + 1];
    const Precise slope = (Precise(pressures[i + 1]) - pressures[i]) / (end - begin);
    const Precise here = pressures[i] + slope * (x - begin);
    sum += integral(here, slope, end - x) - integral(here, slope, begin - x);
  }
  return -steel.integral_compliance() * sum;
}

}  // namespace

BOOST_AUTO_TEST_CASE(gradient_agrees_with_a_hundred_digits) {
  RandomInputs random(33);
  for (int i = 0; i < 2000; ++i) {
    const double x = random.point(1e6);
    const Precise error = abs(normal_gradient(steel, load, x) - exact_gradient(x));
    BOOST_TEST(error.toDouble() < 1e-14 * unit, "x = " << x);
  }
  // beside a position the great logarithms cancel
  for (const double x : {-0.4 + 1e-12, 0.03 - 1e-13, 0.6 + 3e-15}) {
    const Precise error = abs(normal_gradient(steel, load, x) - exact_gradient(x));
    BOOST_TEST(error.toDouble() < 1e-13 * unit, "x = " << x);
  }
}

BOOST_AUTO_TEST_CASE(displacement_is_the_integral_of_the_gradient) {
  for (const double x : {-3.1, -0.5, 0.04, 0.2, 0.7, 1.7, 60.0}) {
    const double h = 1e-5 * std::max(0.1, std::abs(x));
    const double slope = (normal_displacement(steel, load, x + h, datum) -
                          normal_displacement(steel, load, x - h, datum)) /
                         (2 * h);
    BOOST_TEST(std::abs(slope - normal_gradient(steel, load, x)) < 1e-7 * unit);
  }
  BOOST_TEST(normal_displacement(steel, load, datum, datum) == 0);
}

BOOST_AUTO_TEST_CASE(displacement_from_a_far_datum_agrees_with_a_hundred_digits) {
  // The greatest term is that of the whole load at the datum.
  for (const double far : {7.7, 1e3, 1e6}) {
    const double greatest = unit * load.width() * std::log(far / load.width());
    for (const double x : {-3.1, -0.71, -0.4, 0.04, 0.2, 1.9, 60.0}) {
      const Precise error = abs(normal_displacement(steel, load, x, far) -
                                (exact_displacement(x) - exact_displacement(far)));
      BOOST_TEST(error.toDouble() < 1e-14 * greatest, "x = " << x << ", datum " << far);
    }
  }
}

BOOST_AUTO_TEST_CASE(three_points_are_eq_3_and_two_the_uniform_load) {
  const PiecewiseLinearLoad three({-0.75, 0, 0.75}, {0, 2.385, 0});
  const TriangularLoad triangle(2.385, 0.75);
  const PiecewiseLinearLoad two({-0.75, 0.75}, {2.385, 2.385});
  const UniformLoad uniform(2.385, 0.75);
  for (const double x : {-9.0, -0.75, -0.3, 0.0, 0.1, 0.9, 1e4}) {
    BOOST_TEST_CONTEXT("x = " << x) {
      const double length = 0.75 * unit;
      BOOST_TEST(std::abs(normal_gradient(steel, three, x) - normal_gradient(steel, triangle, x)) <
                 1e-14 * unit);
      BOOST_TEST(std::abs(normal_displacement(steel, three, x, datum) -
                          normal_displacement(steel, triangle, x, datum)) < 1e-13 * length);
      BOOST_TEST(std::abs(tangential_displacement(steel, three, x) -
                          tangential_displacement(steel, triangle, x)) < 1e-14 * length);
      BOOST_TEST(std::abs(tangential_gradient(steel, three, x) -
                          tangential_gradient(steel, triangle, x)) < 1e-14 * unit);
      BOOST_TEST(std::abs(normal_displacement(steel, two, x, datum) -
                          normal_displacement(steel, uniform, x, datum)) < 1e-13 * length);
      BOOST_TEST(std::abs(tangential_displacement(steel, two, x) -
                          tangential_displacement(steel, uniform, x)) < 1e-14 * length);
      BOOST_TEST(std::abs(tangential_gradient(steel, two, x) -
                          tangential_gradient(steel, uniform, x)) < 1e-14 * unit);
    }
  }
  BOOST_CHECK_THROW(normal_gradient(steel, two, 0.75), sys::InvalidQuantity);
}

BOOST_AUTO_TEST_CASE(quadrature_gives_the_same_within_its_error_at_kinks_and_between_them) {
  const SurfaceQuadrature surface(steel, load, datum);
  std::vector<double> points = positions;
  points.insert(points.end(), {-5, -0.5, 0.04, 0.1, 1, 3, 80});
  for (const double x : points) {
    BOOST_TEST_CONTEXT("x = " << x) {
      const auto gradient = surface.normal_gradient(x);
      BOOST_TEST(std::abs(gradient.value - normal_gradient(steel, load, x)) <=
                 gradient.abs_error + 1e-14 * unit);
      const auto displacement = surface.normal_displacement(x);
      BOOST_TEST(std::abs(displacement.value - normal_displacement(steel, load, x, datum)) <=
                 displacement.abs_error + 1e-13 * unit);
      const auto tangential = surface.tangential_displacement(x);
      BOOST_TEST(std::abs(tangential.value - tangential_displacement(steel, load, x)) <=
                 tangential.abs_error + 1e-14 * unit);
    }
  }
}

BOOST_AUTO_TEST_CASE(its_resultant_is_that_of_its_trapezia) {
  double total = 0;
  for (std::size_t i = 0; i + 1 < positions.size(); ++i) {
    total += (positions[i + 1] - positions[i]) * (pressures[i] + pressures[i + 1]) / 2;
  }
  BOOST_TEST(relative_difference(load.resultant_below(100), total) < 1e-14);
  BOOST_TEST(load.resultant_below(-1) == 0);
}

BOOST_AUTO_TEST_CASE(bad_loads_are_refused) {
  BOOST_CHECK_THROW(PiecewiseLinearLoad({0}, {1}), sys::InvalidQuantity);
  BOOST_CHECK_THROW(PiecewiseLinearLoad({0, 1}, {1}), sys::InvalidQuantity);
  BOOST_CHECK_THROW(PiecewiseLinearLoad({0, 0}, {1, 1}), sys::InvalidQuantity);
  BOOST_CHECK_THROW(PiecewiseLinearLoad({0, 1}, {1, std::nan("")}), sys::InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
