// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/closed_forms/cone.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "point_contact/polar_quadrature.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(cone_test)

using point_contact::Cone;
using sys::InvalidQuantity;
using tolerance::relative_difference;

namespace {

constexpr double modulus = 913.7;
constexpr double slope = 0.0571;
constexpr double load = 3.461;
const Cone cone(modulus, slope, load);
const double a = cone.radius();

double pressure(double r) {
  return cone.pressure(r);
}

double displacement(double r) {
  return axial_potential(pressure, a, r) / (std::numbers::pi * modulus);
}

}  // namespace

BOOST_AUTO_TEST_CASE(pressure_integrates_to_the_load) {
  numerics::Quadrature quadrature;
  const auto ring = [](double r) { return 2 * std::numbers::pi * r * pressure(r); };
  const double total = quadrature.smooth(ring, 0, a, 1e-10 * load, {"the load", 0}).value;

  BOOST_TEST(relative_difference(total, load) < 1e-9);
}

BOOST_AUTO_TEST_CASE(pressure_closes_the_gap_inside) {
  for (const double share : {0.1, 0.5, 0.9}) {
    const double r = share * a;
    BOOST_TEST(relative_difference(displacement(r) + slope * r, cone.approach()) < 1e-7);
    BOOST_TEST(cone.gap(r) == 0);
  }
}

BOOST_AUTO_TEST_CASE(the_gap_outside_is_that_of_equation_1b) {
  for (const double share : {1.05, 1.5, 3.0}) {
    const double r = share * a;
    BOOST_TEST(std::abs(displacement(r) + slope * r - cone.approach() - cone.gap(r)) <
               1e-7 * slope * r);
  }
}

BOOST_AUTO_TEST_CASE(the_mean_pressure_does_not_depend_on_the_load) {
  const Cone heavier(modulus, slope, 9 * load);
  const double mean = load / (std::numbers::pi * a * a);

  BOOST_TEST(relative_difference(mean, modulus * slope / 2) < 1e-15);
  BOOST_TEST(relative_difference(heavier.radius(), 3 * a) < 1e-15);
}

BOOST_AUTO_TEST_CASE(pressure_is_infinite_at_the_apex_and_zero_from_the_edge_on) {
  BOOST_TEST(std::isinf(cone.pressure(0)));
  BOOST_TEST(cone.pressure(a) == 0);
  BOOST_TEST(cone.pressure(-2 * a) == 0);
}

BOOST_AUTO_TEST_CASE(bad_input_is_refused) {
  BOOST_CHECK_THROW(Cone(0, 1, 1), InvalidQuantity);
  BOOST_CHECK_THROW(Cone(1, 0, 1), InvalidQuantity);
  BOOST_CHECK_THROW(Cone(1, 1, -1), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
