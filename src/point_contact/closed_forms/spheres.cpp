// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/closed_forms/spheres.hpp"

#include <cmath>
#include <numbers>

#include "point_contact/closed_forms/revolution.hpp"
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

Huber::Huber(const Hertz& normal, double nu) : normal_(normal), nu_(nu) {
  if (!(nu > -1 && nu <= 0.5)) {
    throw sys::InvalidQuantity("nu", nu, "greater than -1 and at most 0.5");
  }
}

AxialStress Huber::stress(double r, double z) const {
  sys::require_finite("r", r);
  if (!(sys::require_finite("z", z) >= 0)) {
    throw sys::InvalidQuantity("z", z, "0 or greater, a depth");
  }
  // Lengths in units of a: u² − (r²+z²−1)u − z² = 0, and w² = z²/u solves the same with the sign of
  // the middle term changed.
  const double a = normal_.radius();
  r /= a;
  z /= a;
  const double middle = (r - 1) * (r + 1) + z * z;
  const double root = std::hypot(middle, 2 * z);
  const double u = middle > 0 ? (middle + root) / 2 : (z > 0 ? 2 * z * z / (root - middle) : 0);
  const double w = middle > 0 ? z / std::sqrt(u) : std::sqrt((root - middle) / 2);

  const double sqrt_u = std::sqrt(u);
  const double angle = sqrt_u > 0 ? sqrt_u * std::atan(1 / sqrt_u) : 0;
  const double denominator = u + w * w;
  const double normal = denominator > 0 ? w * w * w / denominator : 0;
  const double shear = denominator > 0 ? r * w * w * sqrt_u / (denominator * (1 + u)) : 0;
  const double surface = (1 - 2 * nu_) / 3 * (1 + w + w * w) / ((1 + w) * (1 + u));
  const double spread = (1 - nu_) * u / (1 + u);

  const double p0 = normal_.peak_pressure();
  return {.rr = p0 * (surface + normal + w * (spread + (1 + nu_) * angle - 2)),
          .tt = -p0 * (surface + w * (2 * nu_ + spread - (1 + nu_) * angle)),
          .zz = -p0 * normal,
          .rz = -p0 * shear};
}

}  // namespace point_contact
