// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/material.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "numerics/require.hpp"
#include "tolerances.hpp"

using elasticity::Material;
using numerics::InvalidQuantity;
using tolerance::relative_difference;

BOOST_AUTO_TEST_CASE(compliances_are_those_of_equation_2) {
  const Material material(30e6, 0.3);

  const double integral = 2 * 0.91 / (std::numbers::pi * 30e6);
  const double local = 0.4 * 1.3 / 30e6;
  BOOST_TEST(relative_difference(material.integral_compliance(), integral) < tolerance::rounding);
  BOOST_TEST(relative_difference(material.local_compliance(), local) < tolerance::rounding);
}

BOOST_AUTO_TEST_CASE(two_equal_materials_halve_the_contact_modulus) {
  const Material steel(207e3, 0.29);
  const double one_body = 207e3 / (1 - 0.29 * 0.29);

  const double both = elasticity::contact_modulus(steel, steel);

  BOOST_TEST(relative_difference(both, one_body / 2) < tolerance::rounding);
}

BOOST_AUTO_TEST_CASE(a_far_stiffer_partner_leaves_the_softer_one) {
  const Material rubber(5, 0.49);
  const Material steel(2e15, 0.3);

  const double both = elasticity::contact_modulus(rubber, steel);

  BOOST_TEST(relative_difference(both, 5 / (1 - 0.49 * 0.49)) < 1e-14);
}

BOOST_AUTO_TEST_CASE(poissons_ratio_outside_its_range_is_refused) {
  for (const double poisson : {-1.0, 0.5, 0.7, -3.0, double(NAN)}) {
    BOOST_CHECK_THROW(Material(30e6, poisson), InvalidQuantity);
  }
  BOOST_CHECK_NO_THROW(Material(30e6, 0.4999));
  BOOST_CHECK_NO_THROW(Material(30e6, -0.9999));
}

BOOST_AUTO_TEST_CASE(youngs_modulus_must_be_positive_and_finite) {
  for (const double young : {0.0, -1.0, double(NAN), std::numeric_limits<double>::infinity()}) {
    BOOST_CHECK_THROW(Material(young, 0.3), InvalidQuantity);
  }
}
