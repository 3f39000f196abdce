// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/closed_forms/flat_punch.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "point_contact/polar_quadrature.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(flat_punch_test)

using point_contact::FlatPunch;
using sys::InvalidQuantity;
using tolerance::relative_difference;

namespace {

constexpr double modulus = 913.7;
constexpr double a = 0.571;
constexpr double load = 3.461;
const FlatPunch punch(modulus, a, load);

// By quadrature; near the edge the pressure is infinite, where QAGS extrapolates.
double displacement(double r) {
  const auto pressure = [](double s) { return s < a ? punch.pressure(s) : 0; };
  return axial_potential(pressure, a, r, 1e-8) / (std::numbers::pi * modulus);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_surface_beneath_stays_flat) {
  for (const double share : {0.0, 0.4, 0.8}) {
    BOOST_TEST(relative_difference(displacement(share * a), punch.approach()) < 1e-6);
    BOOST_TEST(punch.displacement(share * a) == punch.approach());
  }
}

BOOST_AUTO_TEST_CASE(the_surface_beside_sinks_as_by_quadrature) {
  for (const double share : {1.2, 3.0}) {
    BOOST_TEST(relative_difference(displacement(share * a), punch.displacement(share * a)) < 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(the_mean_pressure_is_twice_that_in_the_middle) {
  BOOST_TEST(relative_difference(punch.pressure(0), load / (2 * std::numbers::pi * a * a)) < 1e-15);
  BOOST_TEST(relative_difference(punch.approach(), load / (2 * a * modulus)) < 1e-15);
}

BOOST_AUTO_TEST_CASE(far_away_the_punch_is_a_force) {
  const double r = 1e6 * a;
  BOOST_TEST(relative_difference(punch.displacement(r), load / (std::numbers::pi * modulus * r)) <
             1e-12);
}

BOOST_AUTO_TEST_CASE(pressure_is_infinite_at_the_edge_and_zero_beyond) {
  BOOST_TEST(std::isinf(punch.pressure(a)));
  BOOST_TEST(punch.pressure(1.001 * a) == 0);
}

BOOST_AUTO_TEST_CASE(bad_input_is_refused) {
  BOOST_CHECK_THROW(FlatPunch(0, 1, 1), InvalidQuantity);
  BOOST_CHECK_THROW(FlatPunch(1, -1, 1), InvalidQuantity);
  BOOST_CHECK_THROW(FlatPunch(1, 1, 0), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
