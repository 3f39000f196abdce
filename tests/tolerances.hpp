// SPDX-License-Identifier: GPL-3.0-or-later
// The accuracies that tests require, each with its reason.
#pragma once

#include <cmath>
#include <limits>

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
