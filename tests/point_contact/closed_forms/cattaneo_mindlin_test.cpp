// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/closed_forms/cattaneo_mindlin.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "numerics/quadrature.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(cattaneo_mindlin_test)

using point_contact::CattaneoMindlin;
using point_contact::Hertz;
using sys::InvalidQuantity;
using tolerance::relative_difference;

namespace {

constexpr double load = 3.461;
const Hertz hertz(913.7, 0.571, load);
constexpr double friction = 0.2385;
const double a = hertz.radius();

double resultant(const CattaneoMindlin& shear) {
  numerics::Quadrature quadrature;
  const auto ring = [&](double r) { return 2 * std::numbers::pi * r * shear.traction(r); };
  const double c = shear.stick_radius();
  return quadrature.smooth(ring, 0, c, 1e-11 * load, {"where it sticks", 0}).value +
         (c < a ? quadrature.smooth(ring, c, a, 1e-11 * load, {"where it slips", 0}).value : 0);
}

}  // namespace

BOOST_AUTO_TEST_CASE(traction_integrates_to_the_tangential_load) {
  for (const double share : {0.01, 0.5, -0.9}) {
    const CattaneoMindlin shear(hertz, friction, share * friction * load);
    BOOST_TEST(relative_difference(resultant(shear), share * friction * load) < 1e-8);
  }
}

BOOST_AUTO_TEST_CASE(it_slips_where_the_traction_is_friction_times_pressure) {
  const CattaneoMindlin shear(hertz, friction, 0.6 * friction * load);
  const double c = shear.stick_radius();

  BOOST_TEST(relative_difference(std::pow(c / a, 3), 0.4) < 1e-14);
  for (const double r : {c, (c + a) / 2}) {
    BOOST_TEST(relative_difference(shear.traction(r), friction * hertz.pressure(r)) < 1e-14);
  }
  for (const double r : {0.0, 0.9 * c}) {
    BOOST_TEST(shear.traction(r) < friction * hertz.pressure(r));
    const double difference = friction * hertz.peak_pressure() / a *
                              (std::sqrt(a * a - r * r) - std::sqrt(c * c - r * r));
    BOOST_TEST(relative_difference(shear.traction(r), difference) < 1e-13);
  }
  BOOST_TEST(shear.traction(1.01 * a) == 0);
}

BOOST_AUTO_TEST_CASE(a_small_load_moves_the_spheres_as_if_they_stuck) {
  // δ_x → QC/(8a) (Johnson 7.44), and the traction keeps its digits: Q/(2πa√(a²−r²))
  const double q = 1e-12 * friction * load;
  const CattaneoMindlin shear(hertz, friction, q);

  BOOST_TEST(relative_difference(shear.displacement(0.7), q * 0.7 / (8 * a)) < 1e-11);
  const double r = 0.6137 * a;
  BOOST_TEST(relative_difference(shear.traction(r), q / (2 * std::numbers::pi * a *
                                                         std::sqrt((a - r) * (a + r)))) < 1e-11);
}

BOOST_AUTO_TEST_CASE(at_the_onset_of_sliding_they_have_moved_by_half_as_much_again) {
  const double q = -friction * load * (1 - 1e-12);
  const CattaneoMindlin shear(hertz, friction, q);

  BOOST_TEST(relative_difference(shear.displacement(0.7), 1.5 * q * 0.7 / (8 * a)) < 1e-7);
}

BOOST_AUTO_TEST_CASE(no_load_means_no_traction) {
  const CattaneoMindlin none(hertz, friction, 0);

  BOOST_TEST(none.stick_radius() == a);
  BOOST_TEST(none.displacement(1) == 0);
  for (const double share : {0.0, 0.5, 1.0, 2.0}) BOOST_TEST(none.traction(share * a) == 0);
}

BOOST_AUTO_TEST_CASE(a_load_that_slides_and_bad_friction_are_refused) {
  BOOST_CHECK_THROW(CattaneoMindlin(hertz, friction, friction * load), InvalidQuantity);
  BOOST_CHECK_THROW(CattaneoMindlin(hertz, friction, -2 * friction * load), InvalidQuantity);
  BOOST_CHECK_THROW(CattaneoMindlin(hertz, 0, 0), InvalidQuantity);
  BOOST_CHECK_THROW(CattaneoMindlin(hertz, friction, std::nan("")), InvalidQuantity);
  BOOST_CHECK_THROW(CattaneoMindlin(hertz, friction, 0).displacement(0), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
