// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/closed_forms/power_law.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "point_contact/closed_forms/hertz.hpp"
#include "point_contact/polar_quadrature.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(power_law_test)

using point_contact::Hertz;
using point_contact::PowerLaw;
using sys::InvalidQuantity;
using tolerance::relative_difference;

namespace {

constexpr double modulus = 913.7;
constexpr double load = 3.461;

}  // namespace

BOOST_AUTO_TEST_CASE(the_square_is_hertz) {
  const PowerLaw law(modulus, 0.571 / 2, 1, load);
  const Hertz hertz(modulus, 0.571, load);

  BOOST_TEST(relative_difference(law.radius(), hertz.radius()) < 1e-14);
  BOOST_TEST(relative_difference(law.approach(), hertz.approach()) < 1e-14);
  for (const double share : {0.0, 0.5, 0.99999}) {
    const double r = share * hertz.radius();
    BOOST_TEST(relative_difference(law.pressure(r), hertz.pressure(r)) < 1e-10);
  }
}

BOOST_AUTO_TEST_CASE(pressure_integrates_to_the_load) {
  numerics::Quadrature quadrature;
  for (const int n : {1, 2, 5, 20}) {
    const PowerLaw law(modulus, 0.3, n, load);
    const auto ring = [&](double r) { return 2 * std::numbers::pi * r * law.pressure(r); };
    const double total =
        quadrature.smooth(ring, 0, law.radius(), 1e-10 * load, {"the load", 0}).value;
    BOOST_TEST(relative_difference(total, load) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(pressure_closes_the_gap) {
  for (const int n : {2, 4}) {
    const PowerLaw law(modulus, 0.3, n, load);
    const auto pressure = [&](double r) { return law.pressure(r); };
    for (const double share : {0.0, 0.5, 0.9}) {
      const double r = share * law.radius();
      const double displacement =
          axial_potential(pressure, law.radius(), r) / (std::numbers::pi * modulus);
      BOOST_TEST(relative_difference(displacement + 0.3 * std::pow(r, 2 * n), law.approach()) <
                 1e-7);
    }
  }
}

BOOST_AUTO_TEST_CASE(conforming_bodies_carry_near_the_edge) {
  const PowerLaw law(modulus, 0.3, 10, load);

  BOOST_TEST(law.pressure(0.9 * law.radius()) > law.pressure(0));
  BOOST_TEST(law.pressure(law.radius()) == 0);
}

BOOST_AUTO_TEST_CASE(bad_input_is_refused) {
  BOOST_CHECK_THROW(PowerLaw(modulus, 0.3, 0, load), InvalidQuantity);
  BOOST_CHECK_THROW(PowerLaw(modulus, 0.3, 21, load), InvalidQuantity);
  BOOST_CHECK_THROW(PowerLaw(modulus, 0, 1, load), InvalidQuantity);
  BOOST_CHECK_THROW(PowerLaw(-1, 0.3, 1, load), InvalidQuantity);
  BOOST_CHECK_THROW(PowerLaw(modulus, 0.3, 1, 0), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
