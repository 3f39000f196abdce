// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/closed_forms/hertz.hpp"

#include <cmath>
#include <numbers>

#include "point_contact/closed_forms/tangent.hpp"
#include "system/require.hpp"

namespace point_contact {

Hertz::Hertz(double contact_modulus, double relative_curvature, double load)
    : relative_curvature_(sys::require_positive("relative_curvature", relative_curvature)),
      load_(sys::require_positive("load", load)),
      radius_(std::cbrt(
          3 * load /
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
