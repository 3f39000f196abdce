// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/stress.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "random_inputs.hpp"

BOOST_AUTO_TEST_SUITE(stress_test)

using elasticity::Stress;

namespace {

Stress random_stress(RandomInputs& random) {
  return {random.uniform(-3.7, 2.9), random.uniform(-4.1, 1.3), random.uniform(-2.2, 2.6)};
}

}  // namespace

BOOST_AUTO_TEST_CASE(principal_stresses_and_greatest_shear_bound_those_on_all_planes) {
  RandomInputs random(41);
  constexpr int n_planes = 20000;
  for (int i = 0; i < 20; ++i) {
    const Stress s = random_stress(random);
    double greatest = -1e9, least = 1e9, shear = 0;
    for (int k = 0; k < n_planes; ++k) {
      const double angle = std::numbers::pi * k / n_planes;
      const double c = std::cos(angle), n = std::sin(angle);
      const double normal = s.xx * c * c + s.zz * n * n + 2 * s.xz * c * n;
      greatest = std::max(greatest, normal);
      least = std::min(least, normal);
      shear = std::max(shear, std::abs((s.zz - s.xx) * c * n + s.xz * (c * c - n * n)));
    }
    const auto principal = s.principal(0.29);
    const double across = 0.29 * (s.xx + s.zz);

    // The nearest plane misses the extreme one by half a step: 2 τ₁ (π/2n)², about 1e-7.
    BOOST_TEST(std::abs(principal.front() - std::max(greatest, across)) < 1e-6);
    BOOST_TEST(std::abs(principal.back() - std::min(least, across)) < 1e-6);
    BOOST_TEST(std::abs(s.max_shear() - shear) < 1e-6);
    BOOST_TEST(std::abs(s.largest_shear(0.29) - (principal.front() - principal.back()) / 2) <
               1e-15);
    BOOST_TEST(s.yy(0.29) == across);
  }
}

BOOST_AUTO_TEST_CASE(von_mises_follows_from_the_three_principal_stresses) {
  RandomInputs random(42);
  for (int i = 0; i < 200; ++i) {
    const Stress s = random_stress(random);
    const double nu = random.uniform(-0.99, 0.5);
    const auto [s1, s2, s3] = s.principal(nu);
    const double squares = std::pow(s1 - s2, 2) + std::pow(s2 - s3, 2) + std::pow(s3 - s1, 2);
    BOOST_TEST(std::abs(s.von_mises(nu) - std::sqrt(squares / 2)) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(a_hydrostatic_stress_in_an_incompressible_body_leaves_no_rounding) {
  BOOST_TEST((Stress{-1e9, -1e9, 1}.von_mises(0.5)) == std::numbers::sqrt3);
}

BOOST_AUTO_TEST_SUITE_END()
