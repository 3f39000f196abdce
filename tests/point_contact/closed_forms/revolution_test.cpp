// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/closed_forms/revolution.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "multiprecision.hpp"
#include "point_contact/closed_forms/spheres.hpp"
#include "point_contact/polar_quadrature.hpp"
#include "random_inputs.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(revolution_test)

BOOST_AUTO_TEST_SUITE(tangent)

BOOST_AUTO_TEST_CASE(the_excess_over_the_arctangent_is_right_to_rounding) {
  RandomInputs random(11);
  for (int i = 0; i < 1000; ++i) {
    const double w = random.log_uniform(1e-9, 1e9);
    const Precise exact = Precise(w) - atan(Precise(w));
    const double value = point_contact::excess_over_arctangent(w);
    BOOST_TEST(static_cast<double>(abs(value / exact - 1)) < 1e-15, "at " << w);
  }
  BOOST_TEST(point_contact::excess_over_arctangent(0) == 0);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(flat_punch)

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

BOOST_AUTO_TEST_SUITE(cone)

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

BOOST_AUTO_TEST_SUITE(power_law)

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

BOOST_AUTO_TEST_SUITE_END()
