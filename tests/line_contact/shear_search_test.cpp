// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/shear_search.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "line_contact/mcewen.hpp"
#include "line_contact/sliding_hertz.hpp"
#include "random_inputs.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(shear_search_test)

using line_contact::CylinderPair;
using line_contact::find_greatest_shear;
using line_contact::Hertz;
using line_contact::Radius;
using line_contact::ShearPoint;
using line_contact::SlidingHertz;
using std::numbers::phi;

namespace {

const elasticity::Material steel(30e6, 0.3);
const Hertz hertz(CylinderPair(steel, Radius::of_cylinder("radius1", 1), steel,
                               Radius::of_cylinder("radius2", 3)),
                  2385);
const double a = hertz.half_width();

ShearPoint beneath_sliding(double friction) {
  const SlidingHertz sliding(hertz, friction);
  return find_greatest_shear([&](double x, double z) { return sliding.stress(x, z); }, a, 0.1 * a);
}

}  // namespace

BOOST_AUTO_TEST_CASE(without_friction_the_greatest_shear_is_on_the_axis_at_the_golden_ratio) {
  // p₀ φ^(−5/2) at z = a/√φ: see mcewen_test. The place is known to the root of a rounding.
  const line_contact::McEwen mcewen(hertz);
  const ShearPoint greatest =
      find_greatest_shear([&](double x, double z) { return mcewen.stress(x, z); }, a, 0.1 * a);

  BOOST_TEST(tolerance::relative_difference(greatest.shear,
                                            hertz.peak_pressure() * std::pow(phi, -2.5)) < 1e-13);
  BOOST_TEST(std::abs(greatest.x) < 3e-7 * a);
  BOOST_TEST(std::abs(greatest.z - a / std::sqrt(phi)) < 3e-7 * a);
}

BOOST_AUTO_TEST_CASE(no_point_beneath_sliding_cylinders_has_a_greater_shear) {
  RandomInputs random(72);
  for (const double friction : {-0.31, 0.1, 0.2}) {
    const SlidingHertz sliding(hertz, friction);
    const ShearPoint greatest = beneath_sliding(friction);
    for (int i = 0; i < 5000; ++i) {
      const double x = a * random.uniform(-1.2, 1.2);
      const double z = a * random.uniform(0.1, 1.6);
      BOOST_TEST(sliding.stress(x, z).max_shear() <= greatest.shear);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_place_turns_with_the_shear_and_keeps_the_least_depth) {
  const ShearPoint right = beneath_sliding(0.2);
  const ShearPoint left = beneath_sliding(-0.2);

  BOOST_TEST(std::abs(right.x + left.x) < 1e-6 * a);
  BOOST_TEST(std::abs(right.z - left.z) < 1e-6 * a);
  BOOST_TEST(beneath_sliding(2).z == 0.1 * a);
}

BOOST_AUTO_TEST_CASE(lengths_that_are_not_positive_are_refused) {
  const auto stress = [](double, double) { return elasticity::Stress{}; };
  BOOST_CHECK_THROW(find_greatest_shear(stress, 0, 1), sys::InvalidQuantity);
  BOOST_CHECK_THROW(find_greatest_shear(stress, 1, 0), sys::InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
