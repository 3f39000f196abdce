// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/cylinder_pair.hpp"

#include <cmath>

#include "system/require.hpp"

namespace line_contact {

Radius Radius::of_cylinder(const char* name, double radius) {
  if (!std::isfinite(radius) || radius == 0) {
    throw sys::InvalidQuantity(name, radius,
                               "a finite number other than 0 (negative for a hollow), or a plane");
  }
  return Radius(1 / radius);
}

CylinderPair::CylinderPair(const elasticity::Material& material1, Radius radius1,
                           const elasticity::Material& material2, Radius radius2)
    : relative_curvature_(radius1.curvature() + radius2.curvature()),
      contact_modulus_(elasticity::contact_modulus(material1, material2)) {
  if (!(relative_curvature_ > 0)) {
    throw sys::InvalidQuantity("1/radius1 + 1/radius2", relative_curvature_, "greater than 0");
  }
}

}  // namespace line_contact
