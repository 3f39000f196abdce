// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/line_potential.hpp"

#include <cmath>

namespace elasticity {
namespace {

// From here on, five terms of the series in 1/ξ² are accurate to rounding.
constexpr double far = 16;

// From here on, cancellation between the logarithms of 1 − η² and (1+η)/(1−η), η = 1/ξ, costs at
// most a factor of 3.
constexpr double outside = 2;

double times_log(double t) {
  return t == 0 ? 0 : t * std::log(std::abs(t));
}

double square_times_log(double t) {
  return t == 0 ? 0 : t * t * std::log(std::abs(t));
}

// Φ(ξ) − ln ξ = −Σ 2 ξ^{−2m}/(2m(2m+1)(2m+2)) and Ψ(ξ) − ln ξ = −Σ (2ξ)^{−2m}/(2m(2m+1)),
// m = 1, 2, …, for ξ ≥ far.
double triangle_beyond_logarithm(double xi) {
  const double e = 1 / (xi * xi);
  return -e * (1. / 12 + e * (1. / 60 + e * (1. / 168 + e * (1. / 360 + e / 660))));
}

double strip_beyond_logarithm(double xi) {
  const double e = 1 / (xi * xi);
  return -e * (1. / 24 + e * (1. / 320 + e * (1. / 2688 + e * (1. / 18432 + e / 112640))));
}

}  // namespace

// Under the triangle all terms of (ξ+1)² ln(ξ+1) + (1−ξ)² ln(1−ξ) − 2ξ² ln ξ are of order 1.
// Outside, the large logarithms are separated analytically: with η = 1/ξ the bracket is 2 ln ξ +
// [(1+η)² ln(1+η) + (1−η)² ln(1−η)]/η².
double triangle_potential(double xi) {
  xi = std::abs(xi);
  if (xi >= far) return std::log(xi) + triangle_beyond_logarithm(xi);
  if (xi < outside) {
    return (square_times_log(1 + xi) + square_times_log(1 - xi)) / 2 - square_times_log(xi) - 1.5;
  }
  const double eta = 1 / xi;
  const double square = eta * eta;
  const double bracket = (1 + square) * std::log1p(-square) + 4 * eta * std::atanh(eta);
  return std::log(xi) + bracket / (2 * square) - 1.5;
}

double triangle_gradient(double xi) {
  if (xi < 0) return -triangle_gradient(-xi);
  if (xi < outside) {
    // For small ξ the first two terms are ±ξ, whose digits log1p preserves
    const double below = xi == 1 ? 0 : (1 - xi) * (xi < 1 ? std::log1p(-xi) : std::log(xi - 1));
    return (1 + xi) * std::log1p(xi) - below - 2 * times_log(xi);
  }
  constexpr double negligible_squared = 1e-8;  // 1 + η² rounds to 1
  const double eta = 1 / xi;
  if (eta < negligible_squared) return eta;
  return (std::log1p(-eta * eta) + 2 * eta * std::atanh(eta)) / eta;
}

double triangle_rise(double xi) {
  if (xi < far) return triangle_potential(xi + 1) - triangle_potential(xi);
  return std::log1p(1 / xi) + (triangle_beyond_logarithm(xi + 1) - triangle_beyond_logarithm(xi));
}

double strip_potential(double xi) {
  xi = std::abs(xi);
  if (xi >= far) return std::log(xi) + strip_beyond_logarithm(xi);
  if (xi <= 1) return times_log(xi + 0.5) - times_log(xi - 0.5) - 1;
  return std::log((xi + 0.5) * (xi - 0.5)) / 2 + xi * std::log((xi + 0.5) / (xi - 0.5)) - 1;
}

// The difference of two strips is the slope of a triangle.
double strip_rise(double xi) {
  return triangle_gradient(xi + 0.5);
}

}  // namespace elasticity
