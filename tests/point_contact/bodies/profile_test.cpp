// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/bodies/profile.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(profile_test)

BOOST_AUTO_TEST_SUITE(curvatures)

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

BOOST_AUTO_TEST_SUITE(rough_surface)

using Eigen::ArrayXXd;
using Eigen::Index;
using point_contact::rough_heights;
using point_contact::Roughness;

namespace {

const Roughness roughness{.rms = 2.385, .n_waves = 7, .hurst = 0.8, .seed = 2001};

// The height of the wave (k, l) in a periodic surface, by its Fourier coefficient.
double height_of_wave(const ArrayXXd& heights, int k, int l) {
  const Index n = heights.rows() - 1;  // the last points are the first ones again
  std::complex<double> sum = 0;
  for (Index j = 0; j < n; ++j) {
    for (Index i = 0; i < n; ++i) {
      const double turns = static_cast<double>(k * i + l * j) / static_cast<double>(n);
      sum += heights(i, j) * std::polar(1.0, -2 * std::numbers::pi * turns);
    }
  }
  return 2 * std::abs(sum) / static_cast<double>(n * n);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_mean_square_height_is_what_was_asked_for_and_the_mean_is_zero) {
  const ArrayXXd heights = rough_heights(roughness, 33);
  const auto period = heights.topLeftCorner(32, 32);
  BOOST_TEST(std::abs(std::sqrt(period.square().mean()) / 2.385 - 1) < 1e-13);
  BOOST_TEST(std::abs(period.mean()) < 1e-13);
}

BOOST_AUTO_TEST_CASE(opposite_sides_are_the_same) {
  const ArrayXXd heights = rough_heights(roughness, 40);
  BOOST_TEST((heights.row(0) - heights.row(39)).abs().maxCoeff() < 1e-12);
  BOOST_TEST((heights.col(0) - heights.col(39)).abs().maxCoeff() < 1e-12);
}

BOOST_AUTO_TEST_CASE(heights_of_waves_fall_with_the_power_of_the_hurst_exponent_and_end) {
  const ArrayXXd heights = rough_heights(roughness, 41);
  const double first = height_of_wave(heights, 1, 0);
  for (const auto& [k, l] : {std::pair{0, 1}, {3, 0}, {-3, 4}, {2, 5}, {0, 7}}) {
    const double ratio = height_of_wave(heights, k, l) / first;
    BOOST_TEST(std::abs(ratio * std::pow(std::hypot(k, l), 1.8) - 1) < 1e-11);
  }
  BOOST_TEST(height_of_wave(heights, 0, 8) < 1e-13);
  BOOST_TEST(height_of_wave(heights, 5, 6) < 1e-13);
}

BOOST_AUTO_TEST_CASE(the_seed_decides_the_surface) {
  const ArrayXXd heights = rough_heights(roughness, 20);
  Roughness other = roughness;
  BOOST_TEST((rough_heights(other, 20) == heights).all());
  other.seed = 2002;
  BOOST_TEST((rough_heights(other, 20) - heights).abs().maxCoeff() > 1);
}

BOOST_AUTO_TEST_CASE(roughness_out_of_range_is_refused) {
  const auto refused = [](auto change) {
    Roughness bad = roughness;
    change(bad);
    BOOST_CHECK_THROW(rough_heights(bad, 20), sys::InvalidQuantity);
  };
  refused([](Roughness& r) { r.rms = 0; });
  refused([](Roughness& r) { r.n_waves = 0; });
  refused([](Roughness& r) { r.n_waves = 65; });
  refused([](Roughness& r) { r.hurst = -0.1; });
  refused([](Roughness& r) { r.hurst = std::nan(""); });
  BOOST_CHECK_THROW(rough_heights(roughness, 1), sys::InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
