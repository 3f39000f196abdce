// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/triangular_load.hpp"

#include <algorithm>
#include <cmath>

#include "system/require.hpp"

namespace elasticity {
namespace {

// (1 + t)ⁿ ln|1 + t| for n ≥ 1 and t ≥ −1, with its limit 0 at t = −1.
double power_times_log1p(double t, int n) {
  return t == -1 ? 0 : std::pow(1 + t, n) * std::log1p(t);
}

// The square of anything less is lost in rounding beside 1, and underflows far enough out.
constexpr double negligible_squared = 1e-8;

double power_times_log(double t, int n) {
  return t == 0 ? 0 : std::pow(t, n) * std::log(t);
}

// (ξ+1) ln|ξ+1| + (ξ−1) ln|ξ−1| − 2ξ ln ξ for ξ = x/a ≥ 0.
//
// Under the load all three terms are positive. Outside, with η = 1/ξ, the large logarithms cancel
// by hand and [(1+η) ln(1+η) + (1−η) ln(1−η)]/η remains, whose terms cancel by a factor 3 at most
// once the logarithms of 1 − η² and (1+η)/(1−η) are taken instead.
double gradient_bracket(double x, double a) {
  if (x <= a) {
    const double xi = x / a;
    return power_times_log1p(xi, 1) - power_times_log1p(-xi, 1) - 2 * power_times_log(xi, 1);
  }
  const double eta = a / x;
  if (eta > 0.5) {
    const double one_minus_eta = (x - a) / x;
    return (power_times_log1p(eta, 1) + power_times_log(one_minus_eta, 1)) / eta;
  }
  if (eta < negligible_squared) return eta;  // + η³/6
  return (std::log1p(-eta * eta) + 2 * eta * std::atanh(eta)) / eta;
}

// (ξ+1)² ln|ξ+1| + (ξ−1)² ln|ξ−1| − 2ξ² ln ξ for ξ = x/a ≥ 0; outside as above, plus 2 ln ξ.
double displacement_bracket(double x, double a) {
  if (x <= a) {
    const double xi = x / a;
    return power_times_log1p(xi, 2) + power_times_log1p(-xi, 2) - 2 * power_times_log(xi, 2);
  }
  const double eta = a / x;
  const double large = 2 * std::log(x / a);
  if (eta > 0.5) {
    const double one_minus_eta = (x - a) / x;
    const double sum = power_times_log1p(eta, 2) + power_times_log(one_minus_eta, 2);
    return large + sum / (eta * eta);
  }
  if (eta < negligible_squared) return large + 3;  // − η²/6
  const double square = eta * eta;
  return large + ((1 + square) * std::log1p(-square) + 4 * eta * std::atanh(eta)) / square;
}

}  // namespace

TriangularLoad::operator Load() const {
  const double p0 = peak_pressure();
  const double a = half_width();
  Load load;
  // begin excerpt: equation-4
  load.normal = numerics::PiecewiseFunction({
      {-a, 0, [=](double s) { return p0 / a * (a + s); }},
      {0, a, [=](double s) { return p0 / a * (a - s); }},
  });
  // end excerpt: equation-4
  return load;
}

double normal_gradient(const Material& material, const TriangularLoad& load, double x) {
  sys::require_finite("x", x);
  const double scale = material.integral_compliance() * load.peak_pressure();  // K/a
  const double bracket = gradient_bracket(std::abs(x), load.half_width());
  return x > 0 ? -scale * bracket : scale * bracket;
}

double normal_displacement(const Material& material, const TriangularLoad& load, double x,
                           double datum) {
  const double a = load.half_width();
  const double scale = material.integral_compliance() * load.line_load();  // K
  // Eq. (3): u_z(x) = −K/2 [B(x/a) − B(datum/a)], B the bracket; C is the part with the datum.
  const double here = displacement_bracket(std::abs(sys::require_finite("x", x)), a);
  const double there = displacement_bracket(std::abs(sys::require_finite("datum", datum)), a);
  return -scale / 2 * (here - there);
}

double tangential_displacement(const Material& material, const TriangularLoad& load, double x) {
  // The resultant between −|x| and |x| is P (2ξ − ξ²) with ξ = |x|/a, all of P outside.
  const double xi = std::min(1.0, std::abs(sys::require_finite("x", x)) / load.half_width());
  const double between = load.line_load() * xi * (2 - xi);
  const double magnitude = material.local_compliance() / 2 * between;
  return x > 0 ? -magnitude : magnitude;
}

double triangular_potential(double x, double a) {
  return displacement_bracket(std::abs(x), a) / 2 - 1.5;
}

}  // namespace elasticity
