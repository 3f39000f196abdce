// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/material.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "random_inputs.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(material_test)

using elasticity::Material;
using sys::InvalidQuantity;
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

namespace {

// ½[(1−2ν₁)/G₁ − (1−2ν₂)/G₂]/[(1−ν₁)/G₁ + (1−ν₂)/G₂], G = E/(2(1+ν)) (Johnson 5.3).
double johnsons_beta(const Material& first, const Material& second) {
  const auto shear_modulus = [](const Material& m) { return m.young() / (2 * (1 + m.poisson())); };
  const double g1 = shear_modulus(first);
  const double g2 = shear_modulus(second);
  return 0.5 * ((1 - 2 * first.poisson()) / g1 - (1 - 2 * second.poisson()) / g2) /
         ((1 - first.poisson()) / g1 + (1 - second.poisson()) / g2);
}

}  // namespace

BOOST_AUTO_TEST_CASE(dundurs_constant_is_johnsons) {
  RandomInputs random(2385);
  for (int i = 0; i < 100; ++i) {
    const Material first(random.log_uniform(1, 1e6), random.uniform(-0.9, 0.49));
    const Material second(random.log_uniform(1, 1e6), random.uniform(-0.9, 0.49));
    const double beta = elasticity::dundurs_beta(first, second);

    BOOST_TEST(std::abs(beta - johnsons_beta(first, second)) < tolerance::rounding);
    BOOST_TEST(elasticity::dundurs_beta(second, first) == -beta);
  }
}

BOOST_AUTO_TEST_CASE(dundurs_constant_of_alike_materials_is_zero) {
  BOOST_TEST(elasticity::dundurs_beta(Material(207e3, 0.29), Material(207e3, 0.29)) == 0);
}

BOOST_AUTO_TEST_CASE(a_rigid_partner_leaves_one_half_of_1_minus_2_nu_over_1_minus_nu) {
  // Positive where the first material is the soft one: ½·0.4/0.7 for ν = 0.3, 0 for rubber.
  const Material rigid(2e20, 0.3);

  BOOST_TEST(relative_difference(elasticity::dundurs_beta(Material(207e3, 0.3), rigid), 0.2 / 0.7) <
             1e-14);
  BOOST_TEST(std::abs(elasticity::dundurs_beta(rigid, Material(5, 0.4999999))) < 2e-7);
  BOOST_TEST(relative_difference(elasticity::dundurs_beta(Material(5, 0), rigid), 0.5) < 1e-14);
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

BOOST_AUTO_TEST_SUITE_END()
