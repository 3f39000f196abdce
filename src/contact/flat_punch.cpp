// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/flat_punch.hpp"

#include <cmath>
#include <numbers>

#include "system/require.hpp"

namespace contact {

FlatPunch::FlatPunch(double contact_modulus, double half_width, double line_load)
    : contact_modulus_(sys::require_positive("contact_modulus", contact_modulus)),
      half_width_(sys::require_positive("half_width", half_width)),
      line_load_(sys::require_positive("load", line_load)) {}

double FlatPunch::pressure(double x) const {
  const double a = half_width_;
  if (std::abs(x) > a) return 0;
  return line_load_ / (std::numbers::pi * std::sqrt((a - x) * (a + x)));
}

double FlatPunch::surface_rise(double x) const {
  const double a = half_width_;
  x = std::abs(x);
  if (x <= a) return 0;
  // arcosh(x/a) is written as arsinh(√(x²−a²)/a), which loses no digits near the edge
  return 2 * line_load_ / (std::numbers::pi * contact_modulus_) *
         std::asinh(std::sqrt((x - a) * (x + a)) / a);
}

}  // namespace contact
