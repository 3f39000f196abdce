// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace numerics {

/// A computed number and a bound on how wrong it may be.
///
/// `value` and `abs_error` share one unit; the true number is meant to lie in
/// [value − abs_error, value + abs_error], `abs_error` ≥ 0. Sums and multiples carry the error by
/// the triangle inequality, so the bound stays one when the parts are not independent.
struct Estimate {
  double value = 0;
  double abs_error = 0;

  Estimate& operator+=(Estimate other) {
    value += other.value;
    abs_error += other.abs_error;
    return *this;
  }
};

inline Estimate operator+(Estimate a, Estimate b) {
  return a += b;
}
inline Estimate operator*(double factor, Estimate e) {
  return {factor * e.value, std::abs(factor) * e.abs_error};
}
inline Estimate operator-(Estimate a, Estimate b) {
  return a + (-1.0) * b;
}

}  // namespace numerics
