// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/stress.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "random_inputs.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(stress_test)

using elasticity::Stress;
using sys::InvalidQuantity;
using tolerance::relative_difference;

namespace {

Stress random_stress(RandomInputs& random) {
  return {random.uniform(-3.7, 2.9), random.uniform(-4.1, 1.3), random.uniform(-2.2, 2.6)};
}

// σ_nn on the plane whose normal is turned by `angle` from x towards z.
double normal_stress(const Stress& s, double angle) {
  const double c = std::cos(angle);
  const double n = std::sin(angle);
  return s.xx * c * c + s.zz * n * n + 2 * s.xz * c * n;
}

double shear_stress(const Stress& s, double angle) {
  return (s.zz - s.xx) / 2 * std::sin(2 * angle) + s.xz * std::cos(2 * angle);
}

}  // namespace

BOOST_AUTO_TEST_CASE(principal_stresses_and_greatest_shear_bound_those_of_all_planes) {
  RandomInputs random(41);
  constexpr int n_planes = 20000;
  for (int i = 0; i < 20; ++i) {
    const Stress stress = random_stress(random);
    double greatest = -1e9;
    double least = 1e9;
    double shear = 0;
    for (int k = 0; k < n_planes; ++k) {
      const double angle = std::numbers::pi * k / n_planes;
      greatest = std::max(greatest, normal_stress(stress, angle));
      least = std::min(least, normal_stress(stress, angle));
      shear = std::max(shear, std::abs(shear_stress(stress, angle)));
    }

    // The nearest plane misses the extreme one by half a step: 2 τ₁ (π/2n)², some 1e-7.
    BOOST_TEST(std::abs(stress.principal().greatest - greatest) < 1e-6);
    BOOST_TEST(std::abs(stress.principal().least - least) < 1e-6);
    BOOST_TEST(std::abs(stress.max_shear() - shear) < 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(von_mises_is_that_of_the_three_principal_stresses) {
  RandomInputs random(42);
  for (const double nu : {-0.385, 0.0, 0.277, 0.5}) {
    const Stress stress = random_stress(random);
    const auto [s1, s2] = stress.principal();
    const double s3 = nu * (stress.xx + stress.zz);
    const double squares = std::pow(s1 - s2, 2) + std::pow(s2 - s3, 2) + std::pow(s3 - s1, 2);

    BOOST_TEST(relative_difference(stress.von_mises(nu), std::sqrt(squares / 2)) <
               tolerance::rounding);
  }
}

BOOST_AUTO_TEST_CASE(under_pressure_alone_an_incompressible_body_does_not_yield) {
  const Stress hydrostatic{-2.385, -2.385, 0};

  BOOST_TEST(hydrostatic.max_shear() == 0);
  BOOST_TEST(hydrostatic.von_mises(0.5) == 0);
  BOOST_TEST(relative_difference(hydrostatic.von_mises(0.3), 0.4 * 2.385) < tolerance::rounding);
}

BOOST_AUTO_TEST_CASE(stresses_add_and_scale_component_by_component) {
  const Stress sum = 2.5 * Stress{1.25, -3.5, 0.75} + Stress{0.5, 0.25, -8};

  BOOST_TEST(sum.xx == 3.625);
  BOOST_TEST(sum.zz == -8.5);
  BOOST_TEST(sum.xz == -6.125);
}

BOOST_AUTO_TEST_CASE(poissons_ratios_of_no_material_are_refused) {
  const Stress stress{1.7, -2.385, 0.3};

  BOOST_CHECK_THROW(stress.von_mises(-1), InvalidQuantity);
  BOOST_CHECK_THROW(stress.von_mises(0.501), InvalidQuantity);
  BOOST_CHECK_THROW(stress.von_mises(NAN), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
