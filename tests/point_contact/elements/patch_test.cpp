// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/elements/patch.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

BOOST_AUTO_TEST_SUITE(patch_test)

using point_contact::Patch;
using point_contact::Vector2;

namespace {

const std::array<Vector2, 4> rectangle = {Vector2(0.1, -0.3), Vector2(1.3, 0.2),
                                          Vector2(0.95, 1.04), Vector2(-0.25, 0.54)};
const std::array<double, 4> values = {0.7, -0.4, 2.2, 1.9};

}  // namespace

BOOST_AUTO_TEST_CASE(pressures_have_their_values_at_the_corners) {
  const Patch bilinear = Patch::bilinear(rectangle, values);
  const Patch triangle = Patch::triangle({rectangle[0], rectangle[1], rectangle[3]},
                                         {values[0], values[1], values[3]});
  for (std::size_t k = 0; k < 4; ++k) {
    BOOST_TEST(std::abs(bilinear.about(rectangle[k]).value - values[k]) < 1e-14);
    BOOST_TEST(Patch::uniform(rectangle, 2.385).about(rectangle[k]).value == 2.385);
    if (k != 2) BOOST_TEST(std::abs(triangle.about(rectangle[k]).value - values[k]) < 1e-14);
  }
  BOOST_TEST(bilinear.corners().size() == 4U);
  BOOST_TEST(triangle.corners().size() == 3U);
}

BOOST_AUTO_TEST_CASE(a_bilinear_pressure_is_linear_along_the_edges_and_the_mean_in_the_middle) {
  const Patch patch = Patch::bilinear(rectangle, values);
  for (std::size_t k = 0; k < 4; ++k) {
    const Vector2 between = 0.3 * rectangle[k] + 0.7 * rectangle[(k + 1) % 4];
    const double linear = 0.3 * values[k] + 0.7 * values[(k + 1) % 4];
    BOOST_TEST(std::abs(patch.about(between).value - linear) < 1e-14);
  }
  const Vector2 middle = (rectangle[0] + rectangle[2]) / 2;
  BOOST_TEST(std::abs(patch.about(middle).value - (0.7 - 0.4 + 2.2 + 1.9) / 4) < 1e-14);
}

BOOST_AUTO_TEST_CASE(an_expansion_about_one_point_gives_the_value_at_another) {
  const Patch patch = Patch::bilinear(rectangle, values);
  const Vector2 far(-4.1, 7.3);
  const Vector2 near(0.2, 0.9);
  const auto [value, gradient, hessian] = patch.about(far);
  const Vector2 d = near - far;
  const double at_near = value + gradient.dot(d) + d.dot(hessian * d) / 2;
  BOOST_TEST(std::abs(at_near - patch.about(near).value) < 1e-12);
  BOOST_TEST(std::abs(hessian.trace()) < 1e-15);
}

BOOST_AUTO_TEST_SUITE_END()
