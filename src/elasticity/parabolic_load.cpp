// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/parabolic_load.hpp"

#include <algorithm>
#include <cmath>

#include "elasticity/linear_potential.hpp"
#include "system/require.hpp"

namespace elasticity {
namespace {

// 2ξ + (1−ξ²) ln|(ξ+1)/(ξ−1)| for ξ = x/a ≥ 0.
double parabolic_bracket(double x, double a) {
  const double xi = x / a;
  if (xi > 2) {
    constexpr double negligible = 1e-17;
    const double eta = a / x;
    double sum = 0;
    double power = 1;
    for (double odd = 1; power > negligible; odd += 2) {
      sum += power / (odd * (odd + 2));
      power *= eta * eta;
    }
    return 4 * eta * sum;
  }
  if (x == a) return 2;
  const double below = (a - x) / a;
  const double logarithm = xi < 0.5 ? 2 * std::atanh(xi) : std::log((1 + xi) / std::abs(below));
  return 2 * xi + below * (1 + xi) * logarithm;
}

double parabolic_potential(double x, double a) {
  return element_potential(-1 - x / a, 1 - x / a).middle;
}

}  // namespace

ParabolicLoad::ParabolicLoad(double peak_pressure, double half_width)
    : peak_pressure_(sys::require_positive("peak_pressure", peak_pressure)),
      half_width_(sys::require_positive("half_width", half_width)) {}

ParabolicLoad::operator Load() const {
  const auto pressure = [p0 = peak_pressure_, a = half_width_](double s) {
    return p0 * ((a - s) / a) * ((a + s) / a);
  };
  return distributed_load(pressure, nullptr, {-half_width_, half_width_});
}

double normal_gradient(const Material& material, const ParabolicLoad& load, double x) {
  const double bracket =
      parabolic_bracket(std::abs(sys::require_finite("x", x)), load.half_width());
  const double magnitude = material.integral_compliance() * load.peak_pressure() * bracket;
  return x > 0 ? -magnitude : magnitude;
}

double normal_displacement(const Material& material, const ParabolicLoad& load, double x,
                           double datum) {
  const double a = load.half_width();
  const double here = parabolic_potential(std::abs(sys::require_finite("x", x)), a);
  const double there = parabolic_potential(std::abs(sys::require_finite("datum", datum)), a);
  return -material.integral_compliance() * load.peak_pressure() * a * (here - there);
}

double tangential_gradient(const Material& material, const ParabolicLoad& load, double x) {
  const double a = load.half_width();
  const double distance = std::min(a, std::abs(sys::require_finite("x", x)));
  const double share = (a - distance) / a * ((a + distance) / a);
  return -material.local_compliance() * load.peak_pressure() * share;
}

double tangential_displacement(const Material& material, const ParabolicLoad& load, double x) {
  const double xi = std::min(1.0, std::abs(sys::require_finite("x", x)) / load.half_width());
  const double between = load.peak_pressure() * load.half_width() * xi * (2 - 2 * xi * xi / 3);
  const double magnitude = material.local_compliance() / 2 * between;
  return x > 0 ? -magnitude : magnitude;
}

}  // namespace elasticity
