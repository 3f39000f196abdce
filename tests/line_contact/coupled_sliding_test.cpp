// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/coupled_sliding.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "elasticity/surface_quadrature.hpp"
#include "line_contact/hertz.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(coupled_sliding_test)

using elasticity::Material;
using line_contact::CoupledSliding;
using line_contact::CylinderPair;
using line_contact::Hertz;
using line_contact::Radius;
using std::numbers::pi;
using sys::InvalidQuantity;
using tolerance::relative_difference;

namespace {

constexpr double load = 3.461;
const Material steel(30e6, 0.29);
const Material rubber(700, 0.38);

CylinderPair cylinders_of(const Material& first, const Material& second) {
  return {first, Radius::of_cylinder("radius1", 1.137), second,
          Radius::of_cylinder("radius2", -2.385)};
}

// The departure of the two bodies' slopes by eq. (2) from −x/R, over a/R.
double departure(const CylinderPair& cylinders, const Material& first, const Material& second,
                 double friction) {
  const CoupledSliding exact(cylinders, load, friction, elasticity::dundurs_beta(first, second));
  const double a = exact.half_width();
  const auto body = [&](const Material& material, double mu) {
    return elasticity::SurfaceQuadrature(
        material,
        elasticity::distributed_load([&](double x) { return exact.pressure(x); },
                                     [&, mu](double x) { return mu * exact.pressure(x); },
                                     {exact.shift() - a, exact.shift(), exact.shift() + a}),
        10 * a);
  };
  const auto body1 = body(first, friction);
  const auto body2 = body(second, -friction);
  double largest = 0;
  for (const double share : {-0.97, -0.31, 0.0, 0.123, 0.9}) {
    const double x = exact.shift() + share * a;
    const double slope = body1.normal_gradient(x).value + body2.normal_gradient(x).value;
    largest = std::max(largest, std::abs(slope / cylinders.relative_curvature() + x) / a);
  }
  return largest;
}

}  // namespace

BOOST_AUTO_TEST_CASE(with_its_shear_the_pressure_closes_the_gap_by_equations_1a_and_2) {
  const CylinderPair soft_first = cylinders_of(rubber, steel);
  const CylinderPair soft_second = cylinders_of(steel, rubber);
  for (const double friction : {-1.9, 0.3, 0.8}) {
    BOOST_TEST(departure(soft_first, rubber, steel, friction) < 1e-11);
    BOOST_TEST(departure(soft_second, steel, rubber, friction) < 1e-11);
  }
}

BOOST_AUTO_TEST_CASE(pressure_integrates_to_the_load) {
  // ∫ (a+t)^{1/2+γ} (a−t)^{1/2−γ} dt = (2a)² B(3/2+γ, 3/2−γ), NIST DLMF 5.12.1
  const CylinderPair cylinders = cylinders_of(rubber, steel);
  for (const double friction : {0.3, -2.385, 7.1}) {
    const CoupledSliding contact(cylinders, load, friction, 0.2385);
    const double a = contact.half_width();
    const double factor = contact.pressure(contact.shift()) / a;  // at t = 0
    const double integral =
        factor * 4 * a * a * std::beta(1.5 + contact.gamma(), 1.5 - contact.gamma());
    BOOST_TEST(relative_difference(integral, load) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(without_friction_or_between_like_bodies_it_is_hertz) {
  const CylinderPair cylinders = cylinders_of(rubber, steel);
  const Hertz hertz(cylinders, load);
  for (const CoupledSliding& same :
       {CoupledSliding(cylinders, load, 0, 0.2385), CoupledSliding(cylinders, load, 0.4173, 0)}) {
    BOOST_TEST(same.half_width() == hertz.half_width());
    BOOST_TEST(same.shift() == 0);
    for (const double share : {-0.97, 0.123, 0.8}) {
      const double x = share * hertz.half_width();
      BOOST_TEST(relative_difference(same.pressure(x), hertz.pressure(x)) < 1e-14);
    }
  }
}

BOOST_AUTO_TEST_CASE(gamma_is_that_of_tan_pi_gamma_and_turns_with_the_shear) {
  const CylinderPair cylinders = cylinders_of(rubber, steel);
  const CoupledSliding right(cylinders, load, 0.4173, 0.2385);
  const CoupledSliding left(cylinders, load, -0.4173, 0.2385);

  BOOST_TEST(relative_difference(std::tan(pi * right.gamma()), -0.4173 * 0.2385) < 1e-14);
  BOOST_TEST(relative_difference(right.shift(), 2 * right.gamma() * right.half_width()) < 1e-15);
  for (const double x : {-0.01, 0.0, 0.02}) {
    BOOST_TEST(relative_difference(left.pressure(-x), right.pressure(x)) < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(outside_the_contact_nothing_presses) {
  const CoupledSliding contact(cylinders_of(rubber, steel), load, 0.8, 0.2385);

  BOOST_TEST(contact.pressure(contact.shift() + 1.01 * contact.half_width()) == 0);
  BOOST_TEST(contact.pressure(contact.shift() - 2.385 * contact.half_width()) == 0);
}

BOOST_AUTO_TEST_CASE(inputs_that_are_not_finite_and_loads_that_do_not_press_are_refused) {
  const CylinderPair cylinders = cylinders_of(rubber, steel);
  BOOST_CHECK_THROW(CoupledSliding(cylinders, 0, 0.3, 0.2), InvalidQuantity);
  BOOST_CHECK_THROW(CoupledSliding(cylinders, load, NAN, 0.2), InvalidQuantity);
  BOOST_CHECK_THROW(CoupledSliding(cylinders, load, 0.3, INFINITY), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
