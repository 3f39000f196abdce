// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/bodies/rough_surface.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include "system/require.hpp"

namespace point_contact {
namespace {

void require(const Roughness& roughness, Eigen::Index n) {
  sys::require_positive("rms", roughness.rms);
  if (roughness.n_waves < 1 || roughness.n_waves > max_waves) {
    throw sys::InvalidQuantity("waves", roughness.n_waves, "from 1 to 64");
  }
  if (!(roughness.hurst >= 0 && roughness.hurst <= 1)) {
    throw sys::InvalidQuantity("hurst", roughness.hurst, "from 0 to 1");
  }
  if (n < 2)
    throw sys::InvalidQuantity("points along a side", static_cast<double>(n), "at least 2");
}

}  // namespace

Eigen::ArrayXXd rough_heights(const Roughness& roughness, Eigen::Index n) {
  require(roughness, n);
  const int most = roughness.n_waves;
  // e^{2πikx} at the points, a column for each k from 0 on.
  Eigen::ArrayXXcd waves(n, most + 1);
  for (int k = 0; k <= most; ++k) {
    for (Eigen::Index i = 0; i < n; ++i) {
      const double turns = static_cast<double>(k * i) / static_cast<double>(n - 1);
      waves(i, k) = std::polar(1.0, 2 * std::numbers::pi * turns);
    }
  }

  std::mt19937_64 random(roughness.seed);
  constexpr double random_range = 18446744073709551616.0;  // 2⁶⁴
  Eigen::ArrayXXcd sum = Eigen::ArrayXXcd::Zero(n, n);
  double square = 0;  // of the heights, in the mean
  for (int l = 0; l <= most; ++l) {
    Eigen::ArrayXcd of_row = Eigen::ArrayXcd::Zero(n);  // Σ over k at this l
    for (int k = l == 0 ? 1 : -most; k <= most; ++k) {
      const double q = std::hypot(k, l);
      if (q > most) continue;
      const double height = std::pow(q, -1 - roughness.hurst);
      const double phase = 2 * std::numbers::pi * (static_cast<double>(random()) / random_range);
      const auto along = waves.col(std::abs(k));
      const std::complex<double> amplitude = std::polar(height, phase);
      if (k < 0) {
        of_row += amplitude * along.conjugate();
      } else {
        of_row += amplitude * along;
      }
      square += height * height / 2;
    }
    sum += (of_row.matrix() * waves.col(l).matrix().transpose()).array();
  }
  return roughness.rms / std::sqrt(square) * sum.real();
}

}  // namespace point_contact
