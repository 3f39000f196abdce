// SPDX-License-Identifier: GPL-3.0-or-later
// Random inputs that are the same on every machine and in every run.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

/// std::mt19937_64 is the same everywhere, the standard distributions are not.
class RandomInputs {
 public:
  explicit RandomInputs(std::uint64_t seed) : engine_(seed) {}

  double uniform(double low, double high) {
    constexpr double two_to_minus_53 = 0x1p-53;
    const double fraction = static_cast<double>(engine_() >> 11U) * two_to_minus_53;
    return low + (high - low) * fraction;
  }
  double log_uniform(double low, double high) { return low * std::pow(high / low, uniform(0, 1)); }
  /// A standard normal number, by the Box–Muller method.
  double normal() {
    return std::sqrt(-2 * std::log(1 - uniform(0, 1))) *
           std::cos(2 * std::numbers::pi * uniform(0, 1));
  }
  double sign() { return uniform(-1, 1) < 0 ? -1 : 1; }

  /// A point x/a on the surface: log-uniform up to `far`, within 1e-9 of a kink, or under the load.
  double point(double far) {
    const double kind = uniform(0, 4);
    if (kind < 1) return sign() * (1 + uniform(-1e-9, 1e-9));
    if (kind < 2) return uniform(-1e-9, 1e-9);
    if (kind < 3) return uniform(-2, 2);
    return sign() * log_uniform(1e-12, far);
  }

 private:
  std::mt19937_64 engine_;
};
