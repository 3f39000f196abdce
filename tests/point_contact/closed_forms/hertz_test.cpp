// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/closed_forms/hertz.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "multiprecision.hpp"
#include "point_contact/polar_quadrature.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(hertz_test)

using point_contact::Hertz;
using sys::InvalidQuantity;
using tolerance::relative_difference;

namespace {

constexpr double modulus = 913.7;
constexpr double curvature = 0.571;
constexpr double load = 3.461;
const Hertz hertz(modulus, curvature, load);
const double a = hertz.radius();

double pressure(double r) {
  return hertz.pressure(r);
}

// u_z1 + u_z2 by quadrature.
double displacement(double r) {
  return axial_potential(pressure, a, r) / (std::numbers::pi * modulus);
}

}  // namespace

BOOST_AUTO_TEST_CASE(radius_peak_and_approach_belong_together) {
  // Johnson 4.22–4.24: p₀ = 2aE*κ/π, δ = κa² = πap₀/(2E*)
  BOOST_TEST(relative_difference(hertz.peak_pressure(),
                                 2 * a * modulus * curvature / std::numbers::pi) < 1e-15);
  BOOST_TEST(relative_difference(hertz.approach(), std::numbers::pi * a * hertz.peak_pressure() /
                                                       (2 * modulus)) < 1e-15);
}

BOOST_AUTO_TEST_CASE(pressure_integrates_to_the_load) {
  numerics::Quadrature quadrature;
  const auto ring = [](double r) { return 2 * std::numbers::pi * r * pressure(r); };
  const double total = quadrature.smooth(ring, 0, a, 1e-10 * load, {"the load", 0}).value;

  BOOST_TEST(relative_difference(total, load) < 1e-9);
}

BOOST_AUTO_TEST_CASE(pressure_closes_the_gap_by_equation_1a) {
  for (const double share : {0.0, 0.3, 0.9}) {
    const double r = share * a;
    const double sum = displacement(r) + curvature * r * r / 2;
    BOOST_TEST(relative_difference(sum, hertz.approach()) < 1e-8);
    BOOST_TEST(hertz.gap(r) == 0);
  }
}

BOOST_AUTO_TEST_CASE(the_gap_outside_is_that_of_equation_1b) {
  for (const double share : {1.05, 1.5, 3.0, 12.0}) {
    const double r = share * a;
    const double h = curvature * r * r / 2;
    BOOST_TEST(std::abs(displacement(r) + h - hertz.approach() - hertz.gap(r)) < 1e-8 * h);
  }
}

BOOST_AUTO_TEST_CASE(the_gap_keeps_its_digits_near_the_edge) {
  // (κa²/π) [t tan²t + tan t − t] in a hundred digits
  for (const double beyond : {1e-12, 1e-6, 1e-2, 0.3, 2.0, 1e3}) {
    const double r = a * (1 + beyond);
    const Precise xi = Precise(r) / Precise(a);
    const Precise tangent = sqrt(xi * xi - 1);
    const Precise t = atan(tangent);
    const Precise exact = Precise(hertz.approach()) / mpfr::const_pi() *
                          (t * tangent * tangent + tangent - t);
    BOOST_TEST(static_cast<double>(abs(hertz.gap(r) / exact - 1)) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(pressure_is_zero_from_the_edge_on) {
  BOOST_TEST(hertz.pressure(0) == hertz.peak_pressure());
  BOOST_TEST(hertz.pressure(a) == 0);
  BOOST_TEST(hertz.pressure(-2 * a) == 0);
}

BOOST_AUTO_TEST_CASE(bad_input_is_refused) {
  BOOST_CHECK_THROW(Hertz(0, 1, 1), InvalidQuantity);
  BOOST_CHECK_THROW(Hertz(1, -1, 1), InvalidQuantity);
  BOOST_CHECK_THROW(Hertz(1, 0, 1), InvalidQuantity);
  BOOST_CHECK_THROW(Hertz(1, 1, 0), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
