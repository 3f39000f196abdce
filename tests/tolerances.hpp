// SPDX-License-Identifier: GPL-3.0-or-later
// The rungs of accuracy that tests ask for, each with what it allows for.
#pragma once

#include <cmath>
#include <limits>

namespace tolerance {

inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// A handful of roundings: a closed form of a few operations.
inline constexpr double rounding = 8 * epsilon;

/// What the closed forms of eq. (3) promise for the gradient, relative.
inline constexpr double gradient = 1e-13;

/// What they promise for the displacement, in units of K(1 + ln(datum/a)).
inline constexpr double displacement = 1e-14;

/// What the quadratures may report at most, in units of K or K/a.
inline constexpr double quadrature = 1e-10;

/// |a − b| relative to |b|.
inline double relative_difference(double a, double b) {
  return std::abs(a - b) / std::abs(b);
}

}  // namespace tolerance
