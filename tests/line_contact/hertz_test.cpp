// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/hertz.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "elasticity/surface_quadrature.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(hertz_test)

using elasticity::Material;
using line_contact::CylinderPair;
using line_contact::Hertz;
using line_contact::Radius;
using sys::InvalidQuantity;

namespace {

const Material steel(30e6, 0.3);
const Material rubber(700, 0.48);
const CylinderPair cylinders(steel, Radius::of_cylinder("radius1", 1), rubber,
                             Radius::of_cylinder("radius2", -2.385));
const Hertz hertz(cylinders, 3.5);

elasticity::Load hertz_load() {
  const double a = hertz.half_width();
  return elasticity::distributed_load([](double x) { return hertz.pressure(x); }, nullptr, {-a, a});
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_papers_cylinders_have_their_half_width_and_peak) {
  // a = √(4PR/(πE*)), p₀ = 2P/(πa) with P = 2500 lbf/in, R = 3/4 in, E* = 30e6/(2·0.91) psi.
  const CylinderPair paper(steel, Radius::of_cylinder("radius1", 1), steel,
                           Radius::of_cylinder("radius2", 3));
  const Hertz contact(paper, 2500);

  BOOST_TEST(std::abs(contact.half_width() - 0.012035) < 0.5e-6);
  BOOST_TEST(std::abs(contact.peak_pressure() - 132248) < 0.5);
}

BOOST_AUTO_TEST_CASE(pressure_integrates_to_the_load) {
  const numerics::KernelIntegrals integrals(hertz_load().normal);

  BOOST_TEST(tolerance::relative_difference(integrals.total().value, 3.5) < 1e-10);
}

BOOST_AUTO_TEST_CASE(pressure_closes_the_gap_by_equation_1a) {
  // d/dx (u_z1 + u_z2 + h) = 0 inside; each slope by eq. (2).
  const elasticity::SurfaceQuadrature body1(steel, hertz_load(), 100);
  const elasticity::SurfaceQuadrature body2(rubber, hertz_load(), 100);
  for (const double share : {-0.95, -0.3, 0.123, 0.8}) {
    const double x = share * hertz.half_width();
    const double slope = body1.normal_gradient(x).value + body2.normal_gradient(x).value;
    BOOST_TEST(tolerance::relative_difference(slope, -cylinders.relative_curvature() * x) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(the_gap_outside_is_that_of_equation_1b) {
  // u_z1 + u_z2 + h relative to the edge of the contact, each displacement by quadrature.
  const elasticity::SurfaceQuadrature body1(steel, hertz_load(), 100);
  const elasticity::SurfaceQuadrature body2(rubber, hertz_load(), 100);
  const auto sum = [&](double x) {
    return body1.normal_displacement(x).value + body2.normal_displacement(x).value +
           cylinders.profile().gap(x);
  };
  const double a = hertz.half_width();
  for (const double share : {1.01, 1.5, -3.0, 12.0}) {
    const double gap = sum(share * a) - sum(a);
    BOOST_TEST(std::abs(gap - hertz.gap(share * a)) < 1e-9 * cylinders.profile().gap(share * a));
  }
  BOOST_TEST(hertz.gap(0.9 * a) == 0);
}

BOOST_AUTO_TEST_CASE(the_approach_is_the_displacement_of_both_bodies_in_the_middle) {
  // Eq. (1a) at x = 0, where h = 0; each displacement by quadrature from the datum.
  const double a = hertz.half_width();
  for (const double share : {1.0001, 1.7, -12.0, 2385.0}) {
    const elasticity::SurfaceQuadrature body1(steel, hertz_load(), share * a);
    const elasticity::SurfaceQuadrature body2(rubber, hertz_load(), share * a);
    const double expected = body1.normal_displacement(0).value + body2.normal_displacement(0).value;
    BOOST_TEST(tolerance::relative_difference(hertz.approach(share * a), expected) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(the_approach_at_a_datum_in_contact_is_the_gap_before_deformation) {
  const double a = hertz.half_width();
  for (const double share : {0.0, -0.385, 1.0}) {
    BOOST_TEST(std::abs(hertz.approach(share * a) - cylinders.profile().gap(share * a)) <
               1e-15 * cylinders.profile().gap(a));
  }
  BOOST_CHECK_THROW(hertz.approach(NAN), InvalidQuantity);
}

BOOST_AUTO_TEST_CASE(pressure_is_zero_from_the_edge_on) {
  BOOST_TEST(hertz.pressure(0) == hertz.peak_pressure());
  BOOST_TEST(hertz.pressure(hertz.half_width()) == 0);
  BOOST_TEST(hertz.pressure(-2 * hertz.half_width()) == 0);
}

BOOST_AUTO_TEST_CASE(a_load_must_be_positive) {
  BOOST_CHECK_THROW(Hertz(cylinders, 0), InvalidQuantity);
  BOOST_CHECK_THROW(Hertz(cylinders, -1), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
