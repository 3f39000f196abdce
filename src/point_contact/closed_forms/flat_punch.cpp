// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/closed_forms/flat_punch.hpp"

#include <cmath>
#include <numbers>

#include "system/require.hpp"

namespace point_contact {

FlatPunch::FlatPunch(double contact_modulus, double radius, double load)
    : radius_(sys::require_positive("radius", radius)),
      load_(sys::require_positive("load", load)),
      approach_(load / (2 * radius * sys::require_positive("contact_modulus", contact_modulus))) {}

double FlatPunch::pressure(double r) const {
  const double distance = std::abs(r);
  if (distance > radius_) return 0;
  const double root = std::sqrt((radius_ - distance) * (radius_ + distance));
  return load_ / (2 * std::numbers::pi * radius_ * root);
}

double FlatPunch::displacement(double r) const {
  const double distance = std::abs(r);
  if (distance <= radius_) return approach_;
  return 2 * approach_ / std::numbers::pi * std::asin(radius_ / distance);
}

}  // namespace point_contact
