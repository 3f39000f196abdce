// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/estimate_algebra.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "system/require.hpp"

namespace numerics {
namespace {

using rounding::add_up;
using rounding::multiply_up;
using rounding::next_up;

double next_down(double x) {
  return -next_up(-x);
}

// |a − q·b|, no less than it is; q·b is near a.
double remainder(double a, double q, double b) {
  const double difference = std::abs(std::fma(-q, b, a));
  const bool is_exact =
      std::abs(a) >= rounding::least_product && std::abs(q) >= rounding::least_product;
  return is_exact || a == 0 ? difference : difference + std::numeric_limits<double>::min();
}

// The quotient and the difference of numbers ≥ 0, no less and no more than they are.
double divide_up(double a, double b) {
  return a == 0 ? 0 : next_up(a / b);
}

double subtract_down(double a, double b) {
  const double difference = a - b;
  return rounding::error_of_sum(a, -b, difference) < 0 ? next_down(difference) : difference;
}

// The ends of what an estimate holds.
double lower_end(Estimate a) {
  return subtract_down(a.value, a.abs_error);
}
double upper_end(Estimate a) {
  return -lower_end(-a);
}

// What an operation refuses, with the error that reaches too far.
sys::InvalidQuantity refused(std::string_view quantity, Estimate a, std::string_view allowed) {
  return {quantity, a.value, fmt::format("{} its error, {}", allowed, a.abs_error)};
}

// Infinity and NaN have no bound.
Estimate finite(Estimate result) {
  for (const double number : {result.value, result.abs_error}) {
    sys::require_finite("a number with a bound", number);
  }
  return result;
}

// The value of a function of the C library. Its own documentation gives the errors of those that
// are used here as one unit of the last place or less; two are allowed for.
Estimate from_library(double value) {
  return finite({value, 2 * (next_up(std::abs(value)) - std::abs(value))});
}

// A function that rises, or falls, over all that `a` holds.
template <class Function>
Estimate monotone(Estimate a, Function function) {
  const Estimate at = from_library(function(a.value));
  if (a.abs_error == 0) return at;
  double error = 0;
  for (const double end : {lower_end(a), upper_end(a)}) {
    const Estimate there = from_library(function(end));
    error = std::max(error, add_up(next_up(std::abs(there.value - at.value)), there.abs_error));
  }
  return finite({at.value, error});
}

// A sine or cosine f at a, whose derivative there is f′, with |f″| ≤ 1:
// |f(a + h) − f(a)| ≤ |f′|·|h| + h²/2, and never more than 2.
Estimate of_angle(Estimate a, double f, double derivative) {
  const Estimate at = from_library(f);
  const Estimate slope = from_library(std::abs(derivative));
  const double h = a.abs_error;
  const double change = add_up(multiply_up(add_up(slope.value, slope.abs_error), h),
                               multiply_up(h, multiply_up(h, 0.5)));
  return finite({f, add_up(at.abs_error, std::min(change, 2.0))});
}

}  // namespace

// (a + α)(b + β) − ab = aβ + bα + αβ
Estimate operator*(Estimate a, Estimate b) {
  const double product = a.value * b.value;
  double error = std::abs(rounding::error_of_product(a.value, b.value, product));
  error = add_up(error, multiply_up(std::abs(a.value), b.abs_error));
  error = add_up(error, multiply_up(std::abs(b.value), a.abs_error));
  return finite({product, add_up(error, multiply_up(a.abs_error, b.abs_error))});
}

// With q the rounded quotient, (a + α)/(b + β) − q = ((a − qb) + α − qβ)/(b + β)
Estimate operator/(Estimate a, Estimate b) {
  const double least = subtract_down(std::abs(b.value), b.abs_error);
  if (!(least > 0)) throw refused("divisor", b, "farther from 0 than");
  const double quotient = a.value / b.value;
  double error = remainder(a.value, quotient, b.value);
  error = add_up(error, a.abs_error);
  error = add_up(error, multiply_up(std::abs(quotient), b.abs_error));
  return finite({quotient, divide_up(error, least)});
}

// With r the rounded root, √(a + α) − r = ((a − r²) + α)/(√(a + α) + r)
Estimate sqrt(Estimate a) {
  const double least = lower_end(a);
  if (!(least >= 0)) throw refused("radicand", a, "above 0 by at least");
  if (a.value == 0) return a;
  const double root = std::sqrt(a.value);
  const double error = add_up(remainder(a.value, root, root), a.abs_error);
  return {root, divide_up(error, next_down(root + next_down(std::sqrt(least))))};
}

Estimate pow(Estimate a, double p) {
  const auto power = [p](double x) { return std::pow(x, p); };
  const bool is_whole = p > 0 && std::floor(p) == p;
  if (lower_end(a) > 0 || (is_whole && std::fmod(p, 2) == 1)) return monotone(a, power);
  if (!is_whole) throw refused("base of a power", a, "above 0 by more than");
  if (upper_end(a) < 0) return monotone(-a, power);
  // an even power of what may be zero
  const double most = std::max(-lower_end(a), upper_end(a));
  const Estimate greatest = from_library(power(most));
  return finite({power(a.value), add_up(greatest.value, 2 * greatest.abs_error)});
}

Estimate exp(Estimate a) {
  return monotone(a, [](double x) { return std::exp(x); });
}

Estimate log(Estimate a) {
  if (!(lower_end(a) > 0)) throw refused("argument of log", a, "above 0 by more than");
  return monotone(a, [](double x) { return std::log(x); });
}

Estimate sin(Estimate a) {
  return of_angle(a, std::sin(a.value), std::cos(a.value));
}

Estimate cos(Estimate a) {
  return of_angle(a, std::cos(a.value), std::sin(a.value));
}

Estimate atan(Estimate a) {
  return monotone(a, [](double x) { return std::atan(x); });
}

Estimate abs(Estimate a) {
  return {std::abs(a.value), a.abs_error};
}

Estimate max(Estimate a, Estimate b) {
  return {std::max(a.value, b.value), std::max(a.abs_error, b.abs_error)};
}

Estimate operator*(Estimate a, double b) {
  return b * a;
}
Estimate operator/(Estimate a, double b) {
  return a / Estimate{b, 0};
}
Estimate operator/(double a, Estimate b) {
  return Estimate{a, 0} / b;
}
Estimate operator+(Estimate a, double b) {
  return a + Estimate{b, 0};
}
Estimate operator+(double a, Estimate b) {
  return Estimate{a, 0} + b;
}
Estimate operator-(Estimate a, double b) {
  return a - Estimate{b, 0};
}
Estimate operator-(double a, Estimate b) {
  return Estimate{a, 0} - b;
}

}  // namespace numerics
