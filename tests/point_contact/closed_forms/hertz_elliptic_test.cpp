// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/closed_forms/hertz_elliptic.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "point_contact/closed_forms/spheres.hpp"
#include "point_contact/polar_quadrature.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(hertz_elliptic_test)

using point_contact::Hertz;
using point_contact::HertzElliptic;
using point_contact::Vector2;
using sys::InvalidQuantity;
using tolerance::relative_difference;

namespace {

constexpr double modulus = 913.7;
constexpr double load = 3.461;

// u_z1 + u_z2 by quadrature: the ellipse in its own polar angle about the middle, x = aρ cos, …,
// and at the middle of the contact 1/r leaves ∫ dφ ∫ p dρ ab/√(a²cos² + b²sin²).
double displacement_in_the_middle(const HertzElliptic& hertz) {
  numerics::Quadrature quadrature;
  const double a = hertz.semi_axis_x();
  const double b = hertz.semi_axis_y();
  const auto ray = [&](double angle) {
    // ∫₀¹ √(1−ρ²) dρ = π/4
    return a * b / std::hypot(a * std::cos(angle), b * std::sin(angle)) * std::numbers::pi / 4;
  };
  const double sum =
      4 * quadrature.smooth(ray, 0, std::numbers::pi / 2, 1e-12 * a, {"rays", 0}).value;
  return hertz.peak_pressure() * sum / (std::numbers::pi * modulus);
}

double displacement(const HertzElliptic& hertz, const Vector2& at) {
  const double a = hertz.semi_axis_x();
  const double b = hertz.semi_axis_y();
  const auto pressure = [&](const Vector2& s) { return hertz.pressure(s) / hertz.peak_pressure(); };
  return hertz.peak_pressure() * elliptic_potential(pressure, a, b, at) /
         (std::numbers::pi * modulus);
}

}  // namespace

BOOST_AUTO_TEST_CASE(equal_curvatures_are_hertzs_spheres) {
  const HertzElliptic elliptic(modulus, 0.571, 0.571, load);
  const Hertz circular(modulus, 0.571, load);

  BOOST_TEST(relative_difference(elliptic.semi_axis_x(), circular.radius()) < 1e-14);
  BOOST_TEST(relative_difference(elliptic.semi_axis_y(), circular.radius()) < 1e-14);
  BOOST_TEST(relative_difference(elliptic.peak_pressure(), circular.peak_pressure()) < 1e-14);
  BOOST_TEST(relative_difference(elliptic.approach(), circular.approach()) < 1e-14);
  const double r = 2.385 * circular.radius();
  BOOST_TEST(relative_difference(elliptic.gap({r * 0.6, r * 0.8}), circular.gap(r)) < 1e-13);
}

BOOST_AUTO_TEST_CASE(the_middle_is_displaced_by_the_approach) {
  for (const double ratio : {1.0, 0.3, 0.01, 30.0}) {
    const HertzElliptic hertz(modulus, ratio * 0.571, 0.571, load);
    BOOST_TEST(relative_difference(displacement_in_the_middle(hertz), hertz.approach()) < 1e-10);
  }
}

BOOST_AUTO_TEST_CASE(pressure_closes_the_gap_and_leaves_what_equation_1b_says) {
  const double kx = 0.1;
  const double ky = 0.8;
  // lengths of order one, as the quadrature's tolerance is absolute
  const HertzElliptic hertz(modulus, kx, ky, modulus);
  for (const Vector2& share : {Vector2(0.3, 0.4), Vector2(-0.8, 0.2), Vector2(1.3, 0.2),
                               Vector2(0.1, -1.6), Vector2(2.385, 3.0)}) {
    const Vector2 at(share.x() * hertz.semi_axis_x(), share.y() * hertz.semi_axis_y());
    const double h = (kx * at.x() * at.x() + ky * at.y() * at.y()) / 2;
    const double gap = displacement(hertz, at) + h - hertz.approach();
    BOOST_TEST(std::abs(gap - hertz.gap(at)) < 1e-7 * hertz.approach());
    if (share.norm() < 1) BOOST_TEST(hertz.gap(at) == 0);
  }
}

BOOST_AUTO_TEST_CASE(the_axes_are_those_of_forty_digits) {
  // mpmath 1.2.1, 40 digits: e = findroot of κ_x/κ_y = R_D(0,b²,a²)/R_D(0,a²,b²) with a = 1
  // (elliprd), κ_x/κ_y = 0.05: b/a = 0.1443…; a³ = P R_D(0, (b/a)², 1)/(πE*κ_x).
  const HertzElliptic hertz(1, 0.05, 1, 1);

  BOOST_TEST(relative_difference(hertz.semi_axis_y() / hertz.semi_axis_x(),
                                 0.14432761519028430354) < 1e-14);
  BOOST_TEST(relative_difference(hertz.semi_axis_x(), 3.5556077812007822655) < 1e-14);
  BOOST_TEST(relative_difference(hertz.approach(), 0.44773161910015183275) < 1e-14);
}

BOOST_AUTO_TEST_CASE(exchanging_the_curvatures_exchanges_the_axes) {
  const HertzElliptic one(modulus, 0.02, 0.571, load);
  const HertzElliptic other(modulus, 0.571, 0.02, load);

  BOOST_TEST(one.semi_axis_x() > one.semi_axis_y());
  BOOST_TEST(relative_difference(one.semi_axis_x(), other.semi_axis_y()) < 1e-14);
  BOOST_TEST(relative_difference(one.gap({0.1, 0.2}), other.gap({0.2, 0.1})) < 1e-12);
}

BOOST_AUTO_TEST_CASE(pressure_carries_the_load_and_ends_at_the_ellipse) {
  const HertzElliptic hertz(modulus, 0.1, 0.571, load);
  const double a = hertz.semi_axis_x();
  const double b = hertz.semi_axis_y();

  BOOST_TEST(relative_difference(2 * std::numbers::pi / 3 * a * b * hertz.peak_pressure(), load) <
             1e-15);
  BOOST_TEST(hertz.pressure(Vector2::Zero()) == hertz.peak_pressure());
  BOOST_TEST(hertz.pressure({1.0001 * a, 0}) == 0);
  BOOST_TEST(hertz.pressure({0.8 * a, 0.61 * b}) == 0);
}

BOOST_AUTO_TEST_CASE(bad_input_is_refused) {
  BOOST_CHECK_THROW(HertzElliptic(1, 0, 1, 1), InvalidQuantity);
  BOOST_CHECK_THROW(HertzElliptic(1, 1, -1, 1), InvalidQuantity);
  BOOST_CHECK_THROW(HertzElliptic(1, 1e-9, 1, 1), InvalidQuantity);
  BOOST_CHECK_THROW(HertzElliptic(0, 1, 1, 1), InvalidQuantity);
  BOOST_CHECK_THROW(HertzElliptic(1, 1, 1, 0), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
