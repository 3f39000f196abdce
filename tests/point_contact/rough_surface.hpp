// SPDX-License-Identifier: GPL-3.0-or-later
// A rough surface that is the same on every machine: waves of random phases, their heights falling
// with the wave number as those of a self-affine surface with Hurst exponent 0.8, on a paraboloid.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>

#include "random_inputs.hpp"

/// n × n heights on a square of side 1; `roughness` is the height of the longest wave.
inline Eigen::ArrayXXd rough_surface(Eigen::Index n, double roughness) {
  RandomInputs random(2001);
  Eigen::ArrayXXd heights = Eigen::ArrayXXd::Zero(n, n);
  for (int k = -6; k <= 6; ++k) {
    for (int l = 0; l <= 6; ++l) {
      const double q = std::hypot(k, l);
      const double phase = random.uniform(0, 2 * std::numbers::pi);
      if (q == 0) continue;
      const double height = roughness * std::pow(q, -1.8);
      for (Eigen::Index j = 0; j < n; ++j) {
        for (Eigen::Index i = 0; i < n; ++i) {
          const double turns = static_cast<double>(k * i + l * j) / static_cast<double>(n - 1);
          heights(i, j) += height * std::cos(2 * std::numbers::pi * turns + phase);
        }
      }
    }
  }
  for (Eigen::Index j = 0; j < n; ++j) {
    for (Eigen::Index i = 0; i < n; ++i) {
      const double x = static_cast<double>(i) / static_cast<double>(n - 1) - 0.5;
      const double y = static_cast<double>(j) / static_cast<double>(n - 1) - 0.5;
      heights(i, j) += x * x + y * y;
    }
  }
  return heights;
}
