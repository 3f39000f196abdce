// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/concentrated_load.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(concentrated_load_test)

using elasticity::ConcentratedLoad;
using elasticity::Material;
using elasticity::normal_displacement;
using elasticity::normal_gradient;
using sys::InvalidQuantity;

namespace {

const Material steel(207e3, 0.29);
const ConcentratedLoad load(2.385);

}  // namespace

BOOST_AUTO_TEST_CASE(displacement_falls_by_the_same_amount_in_each_decade) {
  const double decade = steel.integral_compliance() * 2.385 * std::log(10.0);

  BOOST_TEST(normal_displacement(steel, load, 10, 10) == 0);
  for (const double x : {1.0, 0.1, 0.01}) {
    const double drop =
        normal_displacement(steel, load, x, 10) - normal_displacement(steel, load, 10 * x, 10);
    BOOST_TEST(tolerance::relative_difference(drop, decade) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(gradient_falls_with_the_distance) {
  BOOST_TEST(normal_gradient(steel, load, 0.5) < 0);
  BOOST_TEST(normal_gradient(steel, load, 0.5) == 4 * normal_gradient(steel, load, 2));
  BOOST_TEST(normal_gradient(steel, load, -2) == -normal_gradient(steel, load, 2));
}

BOOST_AUTO_TEST_CASE(under_the_force_the_displacement_is_infinite_as_the_paper_says) {
  BOOST_CHECK_THROW(normal_displacement(steel, load, 0, 10), InvalidQuantity);
  BOOST_CHECK_THROW(normal_displacement(steel, load, 1, 0), InvalidQuantity);
  BOOST_CHECK_THROW(normal_gradient(steel, load, 0), InvalidQuantity);
}

BOOST_AUTO_TEST_CASE(the_stress_is_radial_and_falls_with_the_distance) {
  // Johnson (2.14): σ_r = −(2P/π) cos θ/r, and no stress on the planes across.
  for (const double angle : {-1.2, 0.0, 0.385, 1.5}) {
    for (const double r : {0.02385, 17.0}) {
      const double sine = std::sin(angle);
      const double cosine = std::cos(angle);
      const double radial = -2 * 2.385 * cosine / (std::numbers::pi * r);
      const elasticity::Stress s = stress_under(load, r * sine, r * cosine);
      BOOST_TEST(std::abs(s.xx - radial * sine * sine) < 1e-14 * std::abs(radial));
      BOOST_TEST(std::abs(s.zz - radial * cosine * cosine) < 1e-14 * std::abs(radial));
      BOOST_TEST(std::abs(s.xz - radial * sine * cosine) < 1e-14 * std::abs(radial));
    }
  }
}

BOOST_AUTO_TEST_CASE(above_the_surface_and_at_the_force_there_is_no_stress_to_tell) {
  BOOST_CHECK_THROW(stress_under(load, 0, 0), InvalidQuantity);
  BOOST_CHECK_THROW(stress_under(load, 1, -1e-9), InvalidQuantity);
  BOOST_CHECK_THROW(stress_under(load, NAN, 1), InvalidQuantity);
  BOOST_TEST(stress_under(load, 1, 0).max_shear() == 0);
}

BOOST_AUTO_TEST_CASE(a_force_must_be_positive) {
  BOOST_CHECK_THROW(ConcentratedLoad(0), InvalidQuantity);
  BOOST_CHECK_THROW(ConcentratedLoad(-1), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
