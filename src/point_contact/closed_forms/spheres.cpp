// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/closed_forms/spheres.hpp"

#include <cmath>
#include <numbers>

#include "system/require.hpp"

namespace point_contact {
namespace {

// w − arctan w for w ≥ 0 without cancellation: 5e-16 relative.
double excess_over_arctangent(double w) {
  // Beyond 0.6 the subtraction loses less than four bits; below, 40 terms of the series
  // w³/3 − w⁵/5 + … reach rounding.
  constexpr double near = 0.6;
  if (w > near) return w - std::atan(w);
  constexpr int n_terms = 40;
  double sum = 0;
  for (int k = n_terms; k >= 1; --k) sum = 1.0 / (2 * k + 1) - w * w * sum;
  return w * w * w * sum;
}

}  // namespace

Hertz::Hertz(double contact_modulus, double relative_curvature, double load)
    : relative_curvature_(sys::require_positive("relative_curvature", relative_curvature)),
      radius_(std::cbrt(
          3 * sys::require_positive("load", load) /
          (4 * sys::require_positive("contact_modulus", contact_modulus) * relative_curvature))),
      peak_pressure_(3 * load / (2 * std::numbers::pi * radius_ * radius_)) {}

double Hertz::pressure(double r) const {
  // a − r is exact near the edge; 1 − (r/a)² would not be.
  const double from_edge = radius_ - std::abs(r);
  if (from_edge <= 0) return 0;
  return peak_pressure_ / radius_ * std::sqrt(from_edge * (radius_ + std::abs(r)));
}

double Hertz::gap(double r) const {
  const double distance = std::abs(r);
  if (distance <= radius_) return 0;
  const double tangent = std::sqrt((distance - radius_) * (distance + radius_)) / radius_;
  const double bracket = std::atan(tangent) * tangent * tangent + excess_over_arctangent(tangent);
  return approach() / std::numbers::pi * bracket;
}

}  // namespace point_contact
