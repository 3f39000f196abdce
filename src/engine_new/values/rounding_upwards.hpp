// SPDX-License-Identifier: GPL-3.0-or-later
// Sums and products that are no less than the exact ones.
#pragma once

#include <cmath>
#include <limits>

namespace literate::rounding {

/// a + b − sum, exactly, for the rounded sum.
inline double error_of_sum(double a, double b, double sum) {
  const double from_b = sum - a;
  return (a - (sum - from_b)) + (b - from_b);
}

inline double next_up(double x) {
  return std::nextafter(x, std::numeric_limits<double>::infinity());
}

/// a + b, no less than it is.
inline double add_up(double a, double b) {
  const double sum = a + b;
  return error_of_sum(a, b, sum) > 0 ? next_up(sum) : sum;
}

/// a·b, no less than it is.
inline double multiply_up(double a, double b) {
  const double product = a * b;
  return a == 0 || b == 0 || std::fma(a, b, -product) == 0 ? product : next_up(product);
}

}  // namespace literate::rounding
