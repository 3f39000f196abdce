// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/material.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "numbers.hpp"

BOOST_AUTO_TEST_SUITE(material_test)

using elasticity::Material;
using tolerance::relative_difference;

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

BOOST_AUTO_TEST_CASE(compliances_are_those_of_equation_2) {
  const Material material(30e6, 0.3);
  BOOST_TEST(relative_difference(material.integral_compliance(),
                                 2 * 0.91 / (std::numbers::pi * 30e6)) < tolerance::rounding);
  BOOST_TEST(relative_difference(material.local_compliance(), 0.4 * 1.3 / 30e6) <
             tolerance::rounding);
}

BOOST_AUTO_TEST_CASE(the_compliances_of_two_bodies_add_up_to_the_contact_modulus) {
  const Material steel(207e3, 0.29);
  const Material rubber(5, 0.49);
  const double of_steel = 207e3 / (1 - 0.29 * 0.29);
  const double of_rubber = 5 / (1 - 0.49 * 0.49);
  BOOST_TEST(relative_difference(elasticity::contact_modulus(steel, steel), of_steel / 2) <
             tolerance::rounding);
  BOOST_TEST(relative_difference(elasticity::contact_modulus(rubber, steel),
                                 of_steel * of_rubber / (of_steel + of_rubber)) <
             tolerance::rounding);
}

BOOST_AUTO_TEST_CASE(dundurs_constant_matches_johnson_and_is_zero_for_identical_materials) {
  RandomInputs random(2385);
  for (int i = 0; i < 100; ++i) {
    const Material first(random.log_uniform(1, 1e6), random.uniform(-0.9, 0.49));
    const Material second(random.log_uniform(1, 1e6), random.uniform(-0.9, 0.49));
    const double beta = elasticity::dundurs_beta(first, second);
    BOOST_TEST(std::abs(beta - johnsons_beta(first, second)) < tolerance::rounding);
    BOOST_TEST(elasticity::dundurs_beta(second, first) == -beta);
    BOOST_TEST(elasticity::dundurs_beta(first, first) == 0);
  }
}

BOOST_AUTO_TEST_SUITE_END()
