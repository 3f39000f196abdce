// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/cattaneo_mindlin.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "line_contact/cauchy_integral.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(cattaneo_mindlin_test)

using line_contact::CattaneoMindlin;
using line_contact::CylinderPair;
using line_contact::Hertz;
using line_contact::Radius;
using std::numbers::pi;
using sys::InvalidQuantity;

namespace {

constexpr double load = 3.461;
constexpr double friction = 0.4173;
const elasticity::Material rubber(700, 0.48);
const Hertz hertz(CylinderPair(rubber, Radius::of_cylinder("radius1", 1.137), rubber,
                               Radius::of_cylinder("radius2", -2.385)),
                  load);
const double a = hertz.half_width();

constexpr double tangential = -0.6173 * friction * load;
const CattaneoMindlin partial(hertz, friction, tangential);
const double c = partial.stick_half_width();

// The kinks of q are at the edges of the stick zone.
double cauchy(double x) {
  return cauchy_integral([](double s) { return partial.traction(s); }, a, x, c);
}

// At the edges of the stick zone q has a root's infinite slope: what the quadratures then reach.
constexpr double beside_roots = 1e-10;

}  // namespace

BOOST_AUTO_TEST_CASE(traction_integrates_to_the_tangential_load) {
  // Far off, x ∫ q/(x−s) ds → Q, to (a/x)²/4.
  const double far = 2.385e7 * a;

  BOOST_TEST(tolerance::relative_difference(far * cauchy(far), tangential) < beside_roots);
}

BOOST_AUTO_TEST_CASE(the_stick_zone_is_that_of_johnson_7_28) {
  BOOST_TEST(tolerance::relative_difference(c, a * std::sqrt(1 - 0.6173)) < 1e-14);
  BOOST_TEST(partial.half_width() == a);
  BOOST_TEST(partial.tangential_load() == tangential);
}

BOOST_AUTO_TEST_CASE(nothing_slips_in_the_stick_zone) {
  // ∂(u_x1 − u_x2)/∂x = −(2/(πE*)) PV∫ q/(x−s) ds = 0 for |x| < c
  for (const double share : {-0.947, -0.313, 0.1234, 0.7713}) {
    BOOST_TEST(std::abs(cauchy(share * c)) < beside_roots * std::abs(tangential) / a);
  }
}

BOOST_AUTO_TEST_CASE(slip_opposes_the_traction) {
  // Off the stick zone PV∫ q/(x−s) ds = ± π (μp₀/a) √(x²−c²) sgn x. Where q > 0 pulls body 1 along
  // x, u_x1 − u_x2 falls from the stick zone to both sides: it slips against q.
  for (const double share : {-0.947, -0.713, 0.7234, 0.9713}) {
    const double x = share * a;
    const double expected = std::copysign(pi * friction * hertz.peak_pressure() / a, tangential) *
                            std::copysign(std::sqrt((x - c) * (x + c)), x);
    BOOST_TEST(tolerance::relative_difference(cauchy(x), expected) < beside_roots);
  }
}

BOOST_AUTO_TEST_CASE(traction_never_exceeds_friction_and_is_friction_where_it_slips) {
  constexpr int n_points = 2385;
  for (const double share : {1e-15, 3.1e-9, 0.0237, 0.6173, 0.99713}) {
    const CattaneoMindlin shear(hertz, friction, share * friction * load);
    int n_wrong = 0;
    for (int i = -n_points; i <= n_points; ++i) {
      const double x = 1.01 * a * i / n_points;
      const double q = shear.traction(x);
      const double limit = friction * hertz.pressure(x);
      const bool sticks = std::abs(x) < shear.stick_half_width();
      if (!(q >= 0 && (sticks ? q <= limit : q == limit))) ++n_wrong;
    }
    BOOST_TEST(n_wrong == 0);
  }
}

BOOST_AUTO_TEST_CASE(traction_does_not_exceed_friction_beside_the_rounded_edge_of_stick) {
  int n_wrong = 0;
  for (double share = 1e-15; share < 0.9; share *= 1.2385) {
    const CattaneoMindlin shear(hertz, friction, share * friction * load);
    double x = shear.stick_half_width();
    for (int i = 0; i < 8; ++i) {
      if (shear.traction(x) > friction * hertz.pressure(x)) ++n_wrong;
      x = std::nextafter(x, 0);
    }
  }

  BOOST_TEST(n_wrong == 0);
}

BOOST_AUTO_TEST_CASE(traction_is_the_difference_of_two_ellipses) {
  // Johnson (7.24), (7.25)
  const double x = -0.3713 * c;
  const double scale = std::copysign(friction, tangential) * hertz.peak_pressure();
  const double expected =
      scale * (std::sqrt(1 - x * x / (a * a)) - c / a * std::sqrt(1 - x * x / (c * c)));

  BOOST_TEST(tolerance::relative_difference(partial.traction(x), expected) < 1e-14);
}

BOOST_AUTO_TEST_CASE(traction_turns_with_the_load) {
  const CattaneoMindlin reversed(hertz, friction, -tangential);

  for (const double x : {-0.9137 * a, 0.2385 * a, 0.9137 * a}) {
    BOOST_TEST(partial.traction(x) < 0);
    BOOST_TEST(reversed.traction(x) == -partial.traction(x));
    BOOST_TEST(reversed.traction(x) == reversed.traction(-x));
  }
}

BOOST_AUTO_TEST_CASE(without_a_load_all_sticks_and_nothing_is_transmitted) {
  const CattaneoMindlin none(hertz, friction, 0);

  BOOST_TEST(none.stick_half_width() == a);
  for (const double share : {0.0, 0.3137, -1.0, 1.0, 2.385}) {
    BOOST_TEST(none.traction(share * a) == 0);
  }
}

BOOST_AUTO_TEST_CASE(a_small_load_keeps_its_digits) {
  // c → a: q → Q/(π√(a²−x²)), to a part in Q/(μP) = 1e-14
  const double small = 1e-14 * friction * load;
  const CattaneoMindlin shear(hertz, friction, small);
  const double x = 0.6137 * a;
  const double expected = small / (pi * std::sqrt((a - x) * (a + x)));

  BOOST_TEST(tolerance::relative_difference(shear.traction(x), expected) < 1e-13);
}

BOOST_AUTO_TEST_CASE(a_load_that_slides_and_bad_friction_are_refused) {
  const auto says_sliding = [](const InvalidQuantity& error) {
    return error.quantity() == "tangential_load" &&
           error.allowed().find("sliding") != std::string::npos;
  };
  const double limit = friction * load * (1 + 1e-14);
  BOOST_CHECK_EXCEPTION(CattaneoMindlin(hertz, friction, limit), InvalidQuantity, says_sliding);
  BOOST_CHECK_EXCEPTION(CattaneoMindlin(hertz, friction, -limit), InvalidQuantity, says_sliding);
  BOOST_CHECK_NO_THROW(CattaneoMindlin(hertz, friction, -limit * (1 - 1e-13)));
  BOOST_CHECK_THROW(CattaneoMindlin(hertz, friction, std::nan("")), InvalidQuantity);
  BOOST_CHECK_THROW(CattaneoMindlin(hertz, 0, 0), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
