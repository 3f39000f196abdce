// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>

namespace numerics {

/// A computed number with a bound on its error.
///
/// `value` and `abs_error` ≥ 0 share one unit; the true number lies in [value − abs_error, value +
/// abs_error]. Every operation propagates the errors of its operands, assumed independent, and adds
/// its own rounding, ε|value| with ε = 2⁻⁵²: x − x has twice the error of x. A plain number has no
/// error. Where no bound exists, such as for a quotient whose divisor may be zero, the bound is
/// infinite.
///
/// No operation relies on the order of evaluation, so the bounds stay valid where the compiler may
/// change that order (-ffast-math).
struct Estimate {
  double value = 0;
  double abs_error = 0;

  Estimate& operator+=(Estimate other);
};

namespace rounding {

/// A value that was rounded once, with its propagated error, which was itself rounded.
inline Estimate rounded(double value, double error) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  return {value, (1 + 8 * epsilon) * error + epsilon * std::abs(value)};
}

}  // namespace rounding

inline Estimate operator-(Estimate a) {
  return {-a.value, a.abs_error};
}
inline Estimate operator+(Estimate a, Estimate b) {
  return rounding::rounded(a.value + b.value, a.abs_error + b.abs_error);
}
inline Estimate operator-(Estimate a, Estimate b) {
  return a + -b;
}
// (a + α)(b + β) − ab = aβ + bα + αβ
inline Estimate operator*(Estimate a, Estimate b) {
  return rounding::rounded(a.value * b.value, std::abs(a.value) * b.abs_error +
                                                  std::abs(b.value) * a.abs_error +
                                                  a.abs_error * b.abs_error);
}
// (a + α)/(b + β) − a/b = (α − (a/b) β)/(b + β)
inline Estimate operator/(Estimate a, Estimate b) {
  const double least = std::abs(b.value) - b.abs_error;
  const double quotient = a.value / b.value;
  if (!(least > 0)) return {quotient, std::numeric_limits<double>::infinity()};
  return rounding::rounded(quotient, (a.abs_error + std::abs(quotient) * b.abs_error) / least);
}

inline Estimate& Estimate::operator+=(Estimate other) {
  return *this = *this + other;
}

inline Estimate operator+(Estimate a, double b) {
  return a + Estimate{b};
}
inline Estimate operator+(double a, Estimate b) {
  return Estimate{a} + b;
}
inline Estimate operator-(Estimate a, double b) {
  return a - Estimate{b};
}
inline Estimate operator-(double a, Estimate b) {
  return Estimate{a} - b;
}
inline Estimate operator*(Estimate a, double b) {
  return a * Estimate{b};
}
inline Estimate operator*(double a, Estimate b) {
  return Estimate{a} * b;
}
inline Estimate operator/(Estimate a, double b) {
  return a / Estimate{b};
}
inline Estimate operator/(double a, Estimate b) {
  return Estimate{a} / b;
}

/// |a|, with the error of a.
inline Estimate abs(Estimate a) {
  return {std::abs(a.value), a.abs_error};
}

/// The greater of two values, with the greater of their errors.
inline Estimate max(Estimate a, Estimate b) {
  return {a.value < b.value ? b.value : a.value,
          a.abs_error < b.abs_error ? b.abs_error : a.abs_error};
}

/// √a. The bound is |√(a + α) − √a| = |α|/(√(a + α) + √a) ≤ min(|α|/√a, √|α|).
inline Estimate sqrt(Estimate a) {
  const double root = std::sqrt(a.value);
  const double least = std::sqrt(a.abs_error);
  return rounding::rounded(root, least < root ? a.abs_error / root : least);
}

/// The natural logarithm; the bound is infinite where a may be 0.
inline Estimate log(Estimate a) {
  const double relative = a.abs_error / a.value;
  if (!(relative < 1)) return {std::log(a.value), std::numeric_limits<double>::infinity()};
  return rounding::rounded(std::log(a.value), -std::log1p(-relative));
}

inline Estimate exp(Estimate a) {
  const double power = std::exp(a.value);
  return rounding::rounded(power, power * std::expm1(a.abs_error));
}

}  // namespace numerics
