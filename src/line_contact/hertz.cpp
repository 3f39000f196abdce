// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/hertz.hpp"

#include <cmath>
#include <numbers>

#include "system/require.hpp"

namespace line_contact {

Hertz::Hertz(const CylinderPair& cylinders, double line_load)
    : relative_curvature_(cylinders.relative_curvature()),
      half_width_(std::sqrt(
          4 * sys::require_positive("load", line_load) /
          (std::numbers::pi * cylinders.contact_modulus() * cylinders.relative_curvature()))),
      peak_pressure_(2 * line_load / (std::numbers::pi * half_width_)) {}

double Hertz::pressure(double x) const {
  // Near the edge a − |x| is exact, whereas 1 − (x/a)² would lose digits.
  const double from_edge = half_width_ - std::abs(x);
  if (from_edge <= 0) return 0;
  return peak_pressure_ / half_width_ * std::sqrt(from_edge * (half_width_ + std::abs(x)));
}

double Hertz::gap(double x) const {
  const double xi = std::abs(x) / half_width_;
  if (xi <= 1) return 0;
  const double scale = half_width_ * half_width_ * relative_curvature_ / 2;
  return scale * (xi * std::sqrt((xi - 1) * (xi + 1)) - std::acosh(xi));
}

double Hertz::approach(double datum) const {
  const double xi = std::abs(sys::require_finite("datum", datum)) / half_width_;
  const double scale = half_width_ * half_width_ * relative_curvature_ / 2;
  if (xi <= 1) return scale * xi * xi;
  return scale * (xi / (xi + std::sqrt((xi - 1) * (xi + 1))) + std::acosh(xi));
}

}  // namespace line_contact
