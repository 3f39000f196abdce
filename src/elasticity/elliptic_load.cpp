// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/elliptic_load.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "system/require.hpp"

namespace elasticity {
namespace {

// √(ξ² − 1) for ξ ≥ 1, without the square, which may overflow.
double root_outside(double x, double a) {
  return std::sqrt((x - a) / a) * std::sqrt((x + a) / a);
}

// 2 ∫ of the gradient's ξ or ξ − √(ξ²−1).
double elliptic_bracket(double x, double a) {
  const double xi = x / a;
  if (x <= a) return xi * xi;
  const double sum = xi + root_outside(x, a);
  return xi / sum + std::log(sum);
}

}  // namespace

EllipticLoad::EllipticLoad(double peak_pressure, double half_width)
    : peak_pressure_(sys::require_positive("peak_pressure", peak_pressure)),
      half_width_(sys::require_positive("half_width", half_width)) {}

double EllipticLoad::line_load() const {
  return std::numbers::pi / 2 * peak_pressure_ * half_width_;
}

EllipticLoad::operator Load() const {
  const auto pressure = [p0 = peak_pressure_, a = half_width_](double s) {
    return p0 * std::sqrt(std::max(0.0, (a - s) / a * ((a + s) / a)));
  };
  return distributed_load(pressure, nullptr, {-half_width_, half_width_});
}

double normal_gradient(const Material& material, const EllipticLoad& load, double x) {
  const double a = load.half_width();
  const double distance = std::abs(sys::require_finite("x", x));
  const double scale = std::numbers::pi * material.integral_compliance() * load.peak_pressure();
  const double xi = distance / a;
  const double magnitude = scale * (distance <= a ? xi : 1 / (xi + root_outside(distance, a)));
  return x > 0 ? -magnitude : magnitude;
}

double normal_displacement(const Material& material, const EllipticLoad& load, double x,
                           double datum) {
  const double a = load.half_width();
  const double here = elliptic_bracket(std::abs(sys::require_finite("x", x)), a);
  const double there = elliptic_bracket(std::abs(sys::require_finite("datum", datum)), a);
  return -material.integral_compliance() * load.line_load() * (here - there);
}

double tangential_gradient(const Material& material, const EllipticLoad& load, double x) {
  const double a = load.half_width();
  const double distance = std::min(a, std::abs(sys::require_finite("x", x)));
  const double share = (a - distance) / a * ((a + distance) / a);
  return -material.local_compliance() * load.peak_pressure() * std::sqrt(share);
}

double tangential_displacement(const Material& material, const EllipticLoad& load, double x) {
  const double xi = std::min(1.0, std::abs(sys::require_finite("x", x)) / load.half_width());
  const double between = load.peak_pressure() * load.half_width() *
                         (xi * std::sqrt((1 - xi) * (1 + xi)) + std::asin(xi));
  const double magnitude = material.local_compliance() / 2 * between;
  return x > 0 ? -magnitude : magnitude;
}

}  // namespace elasticity
