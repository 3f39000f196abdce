// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "line_contact/element_field.hpp"

namespace paper {

/// Below this depth, over the half-width, the greatest shear is sought: above it the kinks show
/// that only elements have, and wherever bodies slide τ₁ = μp₀ on the surface itself.
inline constexpr double least_shear_depth = 0.1;

/// The greatest shear beneath the surface of a body whose contact has the half-width a.
template <typename Body>
line_contact::ShearPoint greatest_shear(const Body& body, double a) {
  return line_contact::find_greatest_shear([&](double x, double z) { return body.stress(x, z); }, a,
                                           least_shear_depth * a);
}

}  // namespace paper
