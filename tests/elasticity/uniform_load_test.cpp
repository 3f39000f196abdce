// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/uniform_load.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "multiprecision.hpp"
#include "random_inputs.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(uniform_load_test)

using elasticity::Material;
using elasticity::normal_displacement;
using elasticity::normal_gradient;
using elasticity::UniformLoad;
using sys::InvalidQuantity;

namespace {

const Material steel(207e3, 0.29);
const UniformLoad load(2.385, 0.75);

}  // namespace

BOOST_AUTO_TEST_CASE(gradient_agrees_with_a_hundred_digits) {
  RandomInputs random(21);
  const double a = load.half_width();
  for (int i = 0; i < 5000; ++i) {
    const double x = a * random.point(1e9);
    if (x == 0 || std::abs(x) == a) continue;
    const Precise ratio = (Precise(x) + a) / (Precise(x) - a);
    const Precise exact = -steel.integral_compliance() * load.pressure() * log(abs(ratio));
    const Precise error = abs((normal_gradient(steel, load, x) - exact) / exact);
    BOOST_TEST_CONTEXT("x/a = " << x / a) {
      BOOST_TEST(error.toDouble() < 1e-14);
    }
  }
}

BOOST_AUTO_TEST_CASE(displacement_agrees_with_a_hundred_digits) {
  RandomInputs random(22);
  const double a = load.half_width();
  const double unit = steel.integral_compliance() * load.pressure() * a;
  const auto bracket = [](const Precise& xi) {
    return power_log(xi + 1, 1) - power_log(xi - 1, 1);
  };
  for (int i = 0; i < 5000; ++i) {
    const double x = a * random.point(1e3);
    const double datum = 1e3 * a;
    const Precise exact = -unit * (bracket(Precise(x) / a) - bracket(Precise(datum) / a));
    const Precise error = abs(normal_displacement(steel, load, x, datum) - exact);
    BOOST_TEST_CONTEXT("x/a = " << x / a) {
      BOOST_TEST(error.toDouble() < tolerance::displacement * unit * 2 * (1 + std::log(1e3)));
    }
  }
}

BOOST_AUTO_TEST_CASE(gradient_is_infinite_at_the_ends_and_says_so) {
  BOOST_CHECK_THROW(normal_gradient(steel, load, 0.75), InvalidQuantity);
  BOOST_CHECK_THROW(normal_gradient(steel, load, -0.75), InvalidQuantity);
}

BOOST_AUTO_TEST_CASE(sizes_must_be_positive) {
  BOOST_CHECK_THROW(UniformLoad(0, 1), InvalidQuantity);
  BOOST_CHECK_THROW(UniformLoad(1, 0), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
