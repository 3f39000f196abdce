// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/elliptic_load.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "elasticity/surface_quadrature.hpp"
#include "multiprecision.hpp"
#include "random_inputs.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(elliptic_load_test)

using elasticity::EllipticLoad;
using elasticity::Material;
using elasticity::normal_displacement;
using elasticity::normal_gradient;
using elasticity::SurfaceQuadrature;
using tolerance::relative_difference;

namespace {

const Material steel(207e3, 0.29);
const EllipticLoad load(2.385, 0.75);
const double a = load.half_width();
const double datum = 7.7;

}  // namespace

BOOST_AUTO_TEST_CASE(gradient_agrees_with_a_hundred_digits) {
  RandomInputs random(31);
  const Precise scale =
      2 * (1 - Precise(steel.poisson()) * steel.poisson()) / steel.young() * load.peak_pressure();
  for (int i = 0; i < 2000; ++i) {
    const double x = a * random.point(1e9);
    if (x == 0) continue;
    const Precise xi = Precise(x) / a;
    Precise bracket = xi;
    if (xi > 1) bracket = xi - sqrt(xi * xi - 1);
    if (xi < -1) bracket = xi + sqrt(xi * xi - 1);
    const Precise exact = -scale * bracket;
    const Precise error = abs((normal_gradient(steel, load, x) - exact) / exact);
    BOOST_TEST(error.toDouble() < 1e-14, "x/a = " << x / a);
  }
}

BOOST_AUTO_TEST_CASE(displacement_is_the_integral_of_the_gradient) {
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
  BOOST_TEST(normal_displacement(steel, load, 1e200, datum) < 0);
}

BOOST_AUTO_TEST_CASE(quadrature_gives_the_same_within_its_error_inside_outside_and_at_the_edges) {
  const SurfaceQuadrature surface(steel, load, datum);
  const double rounding = 1e-14 * steel.integral_compliance() * load.line_load();
  for (const double x : {-4.0, -a, -0.7, 0.0, 0.2, 0.74, a, 0.76, 3.0}) {
    BOOST_TEST_CONTEXT("x = " << x) {
      const auto gradient = surface.normal_gradient(x);
      BOOST_TEST(std::abs(gradient.value - normal_gradient(steel, load, x)) <=
                 gradient.abs_error + rounding / a);
      BOOST_TEST(gradient.abs_error < 1e-9 * steel.integral_compliance() * load.peak_pressure());
      const auto displacement = surface.normal_displacement(x);
      BOOST_TEST(std::abs(displacement.value - normal_displacement(steel, load, x, datum)) <=
                 displacement.abs_error + 10 * rounding);
      const auto tangential = surface.tangential_displacement(x);
      BOOST_TEST(std::abs(tangential.value - tangential_displacement(steel, load, x)) <=
                 tangential.abs_error + rounding);
      const auto stretch = surface.tangential_gradient(x);
      BOOST_TEST(std::abs(stretch.value - tangential_gradient(steel, load, x)) <=
                 stretch.abs_error + rounding / a);
    }
  }
}

BOOST_AUTO_TEST_CASE(far_away_it_is_a_line_force) {
  const double x = 1e6 * a;
  const double force = -steel.integral_compliance() * load.line_load() / x;
  BOOST_TEST(relative_difference(normal_gradient(steel, load, x), force) < 1e-12);
}

BOOST_AUTO_TEST_CASE(bad_loads_are_refused) {
  BOOST_CHECK_THROW(EllipticLoad(0, 1), sys::InvalidQuantity);
  BOOST_CHECK_THROW(EllipticLoad(1, -1), sys::InvalidQuantity);
  BOOST_CHECK_THROW(normal_gradient(steel, load, std::nan("")), sys::InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
