// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>

namespace numerics {

// Bounds without changing how the processor rounds. The error of a rounded sum or product is a
// double itself: Knuth's TwoSum gives that of a sum, a fused multiply-add that of a product (Muller
// et al., Handbook of Floating-Point Arithmetic, 2nd ed., 4.3 and 4.4). So a bound goes up by one
// place where it was rounded down, and only there.
namespace rounding {

/// a + b − sum, exactly, for the rounded sum.
inline double error_of_sum(double a, double b, double sum) {
  const double from_b = sum - a;
  return (a - (sum - from_b)) + (b - from_b);
}

/// Products below it may have errors that are too small to be a double.
inline constexpr double least_product =
    std::numeric_limits<double>::min() / std::numeric_limits<double>::epsilon();

/// a·b − product for the rounded product; of products below the least, what is surely more.
inline double error_of_product(double a, double b, double product) {
  if (a == 0 || b == 0) return 0;
  if (std::abs(product) < least_product) return std::numeric_limits<double>::min();
  return std::fma(a, b, -product);
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
  return error_of_product(a, b, product) > 0 ? next_up(product) : product;
}

}  // namespace rounding

/// A computed number and a bound on how wrong it may be.
///
/// `value` and `abs_error` share one unit; the true number is meant to lie in
/// [value − abs_error, value + abs_error], `abs_error` ≥ 0. Sums and multiples carry the error by
/// the triangle inequality, so the bound stays one when the parts are not independent; the rounding
/// of the value is part of it, and what is exact stays exact. Products, quotients and functions are
/// in numerics/estimate_algebra.hpp.
struct Estimate {
  double value = 0;
  double abs_error = 0;

  Estimate& operator+=(Estimate other) {
    const double sum = value + other.value;
    const double rounded = std::abs(rounding::error_of_sum(value, other.value, sum));
    abs_error = rounding::add_up(rounding::add_up(abs_error, other.abs_error), rounded);
    value = sum;
    return *this;
  }
};

inline Estimate operator+(Estimate a, Estimate b) {
  return a += b;
}
inline Estimate operator-(Estimate a) {
  return {-a.value, a.abs_error};
}
inline Estimate operator-(Estimate a, Estimate b) {
  return a += -b;
}
inline Estimate operator*(double factor, Estimate e) {
  const double product = factor * e.value;
  const double rounded = std::abs(rounding::error_of_product(factor, e.value, product));
  return {product, rounding::add_up(rounding::multiply_up(std::abs(factor), e.abs_error), rounded)};
}

}  // namespace numerics
