// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/load_shapes.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "elasticity/surface_quadrature.hpp"
#include "multiprecision.hpp"
#include "random_inputs.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(load_shapes_test)

using namespace elasticity;
using sys::InvalidQuantity;
using tolerance::relative_difference;

namespace {

const Material steel(207e3, 0.29);
constexpr double peak = 2.385;
constexpr double a = 0.75;
constexpr double datum = 7.7;
constexpr double line_load = 1.7;

const UniformLoad uniform(peak, a);
const EllipticLoad elliptic(peak, a);
const ParabolicLoad parabolic(peak, a);

LoadNumbers numbers() {
  return {.peak_pressure = peak, .half_width = a, .line_load = line_load, .parameter = 0.6};
}

template <class Shape>
void check_that_displacement_is_the_integral_of_the_gradient(const Shape& load) {
  // central differences, whose error is h²/6 of the third derivative
  for (const double x : {-3.1, -0.9, 0.003, 0.31, 0.86, 1.7, 60.0}) {
    const double h = 1e-5 * std::max(1.0, std::abs(x));
    const double slope = (normal_displacement(steel, load, x + h, datum) -
                          normal_displacement(steel, load, x - h, datum)) /
                         (2 * h);
    const double scale = std::numbers::pi * steel.integral_compliance() * load.peak_pressure();
    BOOST_TEST(std::abs(slope - normal_gradient(steel, load, x)) < 1e-8 * scale);
  }
  BOOST_TEST(normal_displacement(steel, load, datum, datum) == 0);
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_closed_form_is_its_quadrature_inside_outside_and_at_the_edges) {
  const double rounding = 1e-14 * steel.integral_compliance() * 2 * peak * a;
  for (const LoadShape& shape : load_shapes()) {
    const KnownLoad known = shape.make(numbers());
    BOOST_TEST(shape.source.empty() == (known.surface == nullptr), shape.name);
    if (!known.surface) continue;
    const ClosedSurface closed = known.surface(steel, datum);
    const SurfaceQuadrature surface(steel, known.load, datum);
    const bool is_infinite_at_edge = known.load.normal(a) != 0;
    for (const double x : {-4.0, -a, -0.7, 0.0, 0.2, 0.74, a, 0.76, 3.0}) {
      if (x == 0 && !known.load.forces.empty()) continue;
      const auto check = [&](const auto& by_quadrature, double exact, double roundings) {
        BOOST_TEST(std::abs(by_quadrature.value - exact) <= by_quadrature.abs_error + roundings);
        BOOST_TEST(by_quadrature.abs_error < 1e-9 * steel.integral_compliance() * peak);
      };
      BOOST_TEST_CONTEXT(shape.name << ", x = " << x) {
        check(surface.normal_displacement(x), closed.normal_displacement(x), 10 * rounding);
        if (std::abs(x) == a && is_infinite_at_edge) {
          BOOST_CHECK_THROW(closed.normal_gradient(x), InvalidQuantity);
        } else {
          check(surface.normal_gradient(x), closed.normal_gradient(x), rounding / a);
        }
        if (!closed.tangential_displacement) continue;
        check(surface.tangential_displacement(x), closed.tangential_displacement(x), rounding);
        check(surface.tangential_gradient(x), closed.tangential_gradient(x), rounding / a);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(every_load_is_a_line_force_from_far_away) {
  const double x = 1e6 * a;
  for (const LoadShape& shape : load_shapes()) {
    const KnownLoad known = shape.make(numbers());
    if (!known.surface) continue;
    const double force = -steel.integral_compliance() * normal_resultant(known.load) / x;
    const double gradient = known.surface(steel, datum).normal_gradient(x);
    BOOST_TEST(relative_difference(gradient, force) < 1e-12, shape.name);
  }
}

BOOST_AUTO_TEST_CASE(numbers_out_of_range_are_refused_by_every_shape) {
  for (const LoadShape& shape : load_shapes()) {
    for (const LoadNumber& number : load_numbers()) {
      if (std::ranges::find(shape.numbers, number.name) == shape.numbers.end()) continue;
      for (const double wrong : {0.0, -1.0, std::nan("")}) {
        LoadNumbers given = numbers();
        given.*number.number = wrong;
        BOOST_TEST_CONTEXT(shape.name << ", " << number.name << " = " << wrong) {
          BOOST_CHECK_THROW(shape.make(given), InvalidQuantity);
        }
      }
    }
  }
  BOOST_CHECK_THROW(linear_fall(peak, -0.1, a), InvalidQuantity);
  BOOST_CHECK_THROW(power_fall(peak, 0, a), InvalidQuantity);
  BOOST_CHECK_THROW(power_fall(peak, -0.5, a), InvalidQuantity);
  BOOST_CHECK_THROW(scaled(EllipticLoad(peak, a), std::nan("")), InvalidQuantity);
  BOOST_CHECK_THROW(normal_gradient(steel, elliptic, std::nan("")), InvalidQuantity);
  BOOST_CHECK_THROW(normal_gradient(steel, parabolic, std::nan("")), InvalidQuantity);
}

BOOST_AUTO_TEST_CASE(gradient_of_a_uniform_load_agrees_with_a_hundred_digits) {
  RandomInputs random(21);
  for (int i = 0; i < 5000; ++i) {
    const double x = a * random.point(1e9);
    if (x == 0 || std::abs(x) == a) continue;
    const Precise ratio = (Precise(x) + a) / (Precise(x) - a);
    const Precise exact = -steel.integral_compliance() * peak * log(abs(ratio));
    const Precise error = abs((normal_gradient(steel, uniform, x) - exact) / exact);
    BOOST_TEST(error.toDouble() < 1e-14, "x/a = " << x / a);
  }
}

BOOST_AUTO_TEST_CASE(displacement_of_a_uniform_load_agrees_with_a_hundred_digits) {
  RandomInputs random(22);
  const double unit = steel.integral_compliance() * peak * a;
  const auto bracket = [](const Precise& xi) {
    return power_log(xi + 1, 1) - power_log(xi - 1, 1);
  };
  for (int i = 0; i < 5000; ++i) {
    const double x = a * random.point(1e3);
    const double far_datum = 1e3 * a;
    const Precise exact = -unit * (bracket(Precise(x) / a) - bracket(Precise(far_datum) / a));
    const Precise error = abs(normal_displacement(steel, uniform, x, far_datum) - exact);
    BOOST_TEST(error.toDouble() < tolerance::displacement * unit * 2 * (1 + std::log(1e3)),
               "x/a = " << x / a);
  }
}

BOOST_AUTO_TEST_CASE(gradient_of_an_elliptic_load_agrees_with_a_hundred_digits) {
  RandomInputs random(31);
  const Precise scale = 2 * (1 - Precise(steel.poisson()) * steel.poisson()) / steel.young() * peak;
  for (int i = 0; i < 2000; ++i) {
    const double x = a * random.point(1e9);
    if (x == 0) continue;
    const Precise xi = Precise(x) / a;
    Precise bracket = xi;
    if (xi > 1) bracket = xi - sqrt(xi * xi - 1);
    if (xi < -1) bracket = xi + sqrt(xi * xi - 1);
    const Precise exact = -scale * bracket;
    const Precise error = abs((normal_gradient(steel, elliptic, x) - exact) / exact);
    BOOST_TEST(error.toDouble() < 1e-14, "x/a = " << x / a);
  }
}

BOOST_AUTO_TEST_CASE(gradient_of_a_parabolic_load_agrees_with_a_hundred_digits) {
  RandomInputs random(32);
  const Precise scale = Precise(steel.integral_compliance()) * peak;
  for (int i = 0; i < 2000; ++i) {
    const double x = a * random.point(1e9);
    if (x == 0 || std::abs(x) == a) continue;
    const Precise xi = Precise(x) / a;
    const Precise exact = -scale * (2 * xi + (1 - xi * xi) * log(abs((xi + 1) / (xi - 1))));
    const Precise error = abs((normal_gradient(steel, parabolic, x) - exact) / exact);
    BOOST_TEST(error.toDouble() < 1e-14, "x/a = " << x / a);
  }
}

BOOST_AUTO_TEST_CASE(displacements_are_the_integrals_of_the_gradients) {
  check_that_displacement_is_the_integral_of_the_gradient(elliptic);
  check_that_displacement_is_the_integral_of_the_gradient(parabolic);
  BOOST_TEST(normal_displacement(steel, elliptic, 1e200, datum) < 0);
}

BOOST_AUTO_TEST_CASE(resultants_are_those_of_the_shapes) {
  BOOST_CHECK_CLOSE(normal_resultant(linear_fall(peak, 0.6, a)), 1.6 * peak * a, 1e-9);
  BOOST_CHECK_CLOSE(normal_resultant(power_fall(peak, 4, a)), 1.6 * peak * a, 1e-9);
  BOOST_CHECK_CLOSE(normal_resultant(power_fall(peak, 3, a)), 1.5 * peak * a, 1e-9);
  BOOST_CHECK_CLOSE(normal_resultant(power_fall(peak, 1, a)), peak * a, 1e-9);
  BOOST_CHECK_CLOSE(normal_resultant(power_fall(peak, 0.5, a)), 2. / 3 * peak * a, 1e-9);
  BOOST_CHECK_CLOSE(normal_resultant(elliptic), elliptic.line_load(), 1e-9);
  BOOST_CHECK_CLOSE(normal_resultant(parabolic), parabolic.line_load(), 1e-9);
  BOOST_CHECK_CLOSE(normal_resultant(uniform), uniform.line_load(), 1e-9);
  BOOST_CHECK_CLOSE(normal_resultant(cosine_fall(peak, a)), peak * a, 1e-9);
}

BOOST_AUTO_TEST_CASE(every_fall_has_its_peak_in_the_middle_and_its_value_at_the_edge) {
  for (const Load& load :
       {linear_fall(peak, 0, a), Load(elliptic), Load(parabolic), cosine_fall(peak, a),
        power_fall(peak, 4, a), power_fall(peak, 0.7, a)}) {
    BOOST_CHECK_CLOSE(load.normal(0), peak, 1e-10);
    BOOST_TEST(std::abs(load.normal(a)) < 1e-10);
    BOOST_CHECK_CLOSE(load.normal(0.21 * a), load.normal(-0.21 * a), 1e-10);
  }
  BOOST_CHECK_CLOSE(linear_fall(peak, 0.6, a).normal(0.5 * a), 0.8 * peak, 1e-10);
  BOOST_CHECK_CLOSE(power_fall(peak, 0.5, a).normal(0.25 * a), 0.5 * peak, 1e-10);
  BOOST_CHECK_CLOSE(cosine_fall(peak, a).normal(a / 3), 0.75 * peak, 1e-10);
}

BOOST_AUTO_TEST_CASE(scaling_multiplies_all_that_acts) {
  Load load = linear_fall(peak, 0.6, a);
  load.forces = {{0.1, 3}};

  const Load twice = scaled(load, 2.5);

  BOOST_CHECK_CLOSE(twice.normal(0.1), 2.5 * load.normal(0.1), 1e-10);
  BOOST_CHECK_CLOSE(normal_resultant(twice), 2.5 * normal_resultant(load), 1e-8);
}

BOOST_AUTO_TEST_SUITE_END()
