// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/bodies/rough_surface.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>
#include <numbers>

#include "system/require.hpp"

BOOST_AUTO_TEST_SUITE(rough_surface_test)

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
