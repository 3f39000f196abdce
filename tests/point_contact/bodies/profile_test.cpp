// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/bodies/profile.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(profile_test)

using point_contact::Profile;
using point_contact::Vector2;
using sys::InvalidQuantity;
using tolerance::relative_difference;

namespace {

const Vector2 at(0.3, -0.4);  // r = 0.5

}  // namespace

BOOST_AUTO_TEST_CASE(profiles_have_the_gap_of_their_formula) {
  BOOST_TEST(relative_difference(Profile::paraboloid(0.571).gap(at), 0.571 * 0.25 / 2) < 1e-15);
  BOOST_TEST(relative_difference(Profile::elliptic_paraboloid(0.2, 3).gap(at),
                                 (0.2 * 0.09 + 3 * 0.16) / 2) < 1e-15);
  BOOST_TEST(relative_difference(Profile::cone(0.1).gap(at), 0.05) < 1e-15);
  BOOST_TEST(relative_difference(Profile::power_law(2, 3).gap(at), 2 * std::pow(0.5, 6)) < 1e-14);
  BOOST_TEST(relative_difference(Profile::rounded_punch(0.2, 4).gap(at), 4 * 0.09 / 2) < 1e-14);
  BOOST_TEST(Profile::rounded_punch(0.6, 4).gap(at) == 0);
}

BOOST_AUTO_TEST_CASE(beside_a_flat_punch_there_is_no_body) {
  const Profile punch = Profile::flat_punch(0.5 + 1e-12);

  BOOST_TEST(punch.gap(at) == 0);
  BOOST_TEST(std::isinf(punch.gap(1.001 * at)));
}

BOOST_AUTO_TEST_CASE(a_height_map_meets_its_points_and_smooth_surfaces_between) {
  constexpr Eigen::Index n1 = 31;
  constexpr Eigen::Index n2 = 21;
  constexpr double spacing = 0.1;
  const auto surface = [](double x, double y) { return std::sin(x) * std::cos(2 * y) + 0.3 * x; };
  const Eigen::ArrayXXd heights = Eigen::ArrayXXd::NullaryExpr(n1, n2, [&](auto i, auto j) {
    return surface((static_cast<double>(i) - 15) * spacing,
                   (static_cast<double>(j) - 10) * spacing);
  });
  const Profile map = Profile::height_map(heights, spacing);

  BOOST_TEST((map.half_sides() - Vector2(1.5, 1.0)).norm() < 1e-15);
  BOOST_TEST(std::abs(map.gap({0.5, -0.3}) - surface(0.5, -0.3)) < 1e-14);
  BOOST_TEST(std::abs(map.gap({0.537, -0.211}) - surface(0.537, -0.211)) < 1e-4);
}

BOOST_AUTO_TEST_CASE(bad_profiles_are_refused) {
  BOOST_CHECK_THROW(Profile::paraboloid(0), InvalidQuantity);
  BOOST_CHECK_THROW(Profile::elliptic_paraboloid(1, -1), InvalidQuantity);
  BOOST_CHECK_THROW(Profile::cone(-0.1), InvalidQuantity);
  BOOST_CHECK_THROW(Profile::flat_punch(0), InvalidQuantity);
  BOOST_CHECK_THROW(Profile::rounded_punch(-1, 1), InvalidQuantity);
  BOOST_CHECK_THROW(Profile::rounded_punch(1, 0), InvalidQuantity);
  BOOST_CHECK_THROW(Profile::power_law(1, 21), InvalidQuantity);
  BOOST_CHECK_THROW(Profile::power_law(0, 2), InvalidQuantity);
  BOOST_CHECK_THROW(Profile::height_map(Eigen::ArrayXXd::Zero(3, 9), 1), InvalidQuantity);
  BOOST_CHECK_THROW(Profile::height_map(Eigen::ArrayXXd::Zero(9, 3), 1), InvalidQuantity);
  BOOST_CHECK_THROW(Profile::height_map(Eigen::ArrayXXd::Zero(9, 9), 0), InvalidQuantity);
  Eigen::ArrayXXd with_hole = Eigen::ArrayXXd::Zero(9, 9);
  with_hole(3, 4) = std::nan("");
  BOOST_CHECK_THROW(Profile::height_map(with_hole, 1), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
