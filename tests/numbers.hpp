// SPDX-License-Identifier: GPL-3.0-or-later
// The accuracies that tests require, each with its reason, and random inputs that are the same on
// every machine and in every run.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>

namespace tolerance {

inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// A few roundings: a closed form of a few operations.
inline constexpr double rounding = 8 * epsilon;

/// The relative accuracy stated for the gradient of eq. (3).
inline constexpr double gradient = 1e-13;

/// The accuracy stated for the displacement of eq. (3), in units of K(1 + ln(datum/a)).
inline constexpr double displacement = 1e-14;

/// The greatest error that the quadratures may report, in units of K or K/a.
inline constexpr double quadrature = 1e-10;

/// |a − b| relative to |b|.
inline double relative_difference(double a, double b) {
  return std::abs(a - b) / std::abs(b);
}

}  // namespace tolerance

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
