// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/bodies/curvatures.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(curvatures_test)

using point_contact::PrincipalCurvatures;
using point_contact::relative_curvatures;
using point_contact::RelativeCurvatures;
using sys::InvalidQuantity;
using tolerance::relative_difference;

namespace {

// The gap of two bodies at the distance 1 and the angle θ from the first one's first direction.
double gap(PrincipalCurvatures one, PrincipalCurvatures two, double angle, double theta) {
  const auto height = [](PrincipalCurvatures k, double t) {
    return (k.first * std::cos(t) * std::cos(t) + k.second * std::sin(t) * std::sin(t)) / 2;
  };
  return height(one, theta) + height(two, theta - angle);
}

}  // namespace

BOOST_AUTO_TEST_CASE(relative_curvatures_give_the_gap_of_the_bodies_in_all_directions) {
  const PrincipalCurvatures one{1.3, 0.2};
  const PrincipalCurvatures two{0.7, -0.1};
  for (const double angle : {0.0, 0.4, 1.2, -2.0}) {
    const RelativeCurvatures relative = relative_curvatures(one, two, angle);
    BOOST_TEST(relative.x <= relative.y);
    for (const double theta : {0.0, 0.3, 1.1, 2.5}) {
      const double along = std::cos(theta - relative.angle);
      const double across = std::sin(theta - relative.angle);
      const double h = (relative.x * along * along + relative.y * across * across) / 2;
      BOOST_TEST(std::abs(h - gap(one, two, angle, theta)) < 1e-15);
    }
  }
}

BOOST_AUTO_TEST_CASE(crossed_equal_cylinders_touch_in_a_circle) {
  const RelativeCurvatures relative = relative_curvatures({0.5, 0}, {0.5, 0}, std::numbers::pi / 2);

  BOOST_TEST(relative_difference(relative.x, 0.5) < 1e-15);
  BOOST_TEST(relative_difference(relative.y, 0.5) < 1e-15);
}

BOOST_AUTO_TEST_CASE(a_sphere_in_a_wider_hollow_has_the_difference_of_their_curvatures) {
  const RelativeCurvatures relative = relative_curvatures({2, 2}, {-1.5, -1.5}, 0.3);

  BOOST_TEST(relative_difference(relative.x, 0.5) < 1e-15);
  BOOST_TEST(relative_difference(relative.y, 0.5) < 1e-15);
}

BOOST_AUTO_TEST_CASE(bodies_that_do_not_touch_at_a_point_alone_are_refused) {
  // parallel cylinders, a sphere in a hollow as wide, in a narrower one, and a saddle
  BOOST_CHECK_THROW(relative_curvatures({1, 0}, {1, 0}, 0), InvalidQuantity);
  BOOST_CHECK_THROW(relative_curvatures({1, 1}, {-1, -1}, 0), InvalidQuantity);
  BOOST_CHECK_THROW(relative_curvatures({1, 1}, {-2, -2}, 0), InvalidQuantity);
  BOOST_CHECK_EXCEPTION(relative_curvatures({3, 1}, {0, -1.5}, 0), InvalidQuantity,
                        [](const InvalidQuantity& error) {
                          return error.quantity() == "least relative curvature" &&
                                 std::string(error.what()).find("-0.5") != std::string::npos;
                        });
  BOOST_CHECK_THROW(relative_curvatures({1, 1}, {1, 1}, std::nan("")), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
