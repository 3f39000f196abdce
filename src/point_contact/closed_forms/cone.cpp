// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/closed_forms/cone.hpp"

#include <cmath>
#include <numbers>

#include "point_contact/closed_forms/tangent.hpp"
#include "system/require.hpp"

namespace point_contact {

Cone::Cone(double contact_modulus, double slope, double load)
    : contact_modulus_(sys::require_positive("contact_modulus", contact_modulus)),
      slope_(sys::require_positive("slope", slope)),
      radius_(std::sqrt(2 * sys::require_positive("load", load) /
                        (std::numbers::pi * contact_modulus * slope))) {}

double Cone::approach() const {
  return std::numbers::pi / 2 * radius_ * slope_;
}

double Cone::pressure(double r) const {
  const double distance = std::abs(r);
  if (distance >= radius_) return 0;
  // arcosh(a/r) = arsinh(√(a²−r²)/r), which keeps its digits at the edge
  const double root = std::sqrt((radius_ - distance) * (radius_ + distance));
  return contact_modulus_ * slope_ / 2 * std::asinh(root / distance);
}

double Cone::gap(double r) const {
  const double distance = std::abs(r);
  if (distance <= radius_) return 0;
  const double tangent = std::sqrt((distance - radius_) * (distance + radius_)) / radius_;
  return radius_ * slope_ * excess_over_arctangent(tangent);
}

}  // namespace point_contact
