// SPDX-License-Identifier: GPL-3.0-or-later
// The correct answers, computed by the mechanics of this project, and the pressures and places at
// which the hidden checks compare with them.
#pragma once

#include <string>
#include <vector>

#include "assignment/given/bodies.hpp"

namespace assignment {

/// ∂u_z/∂x at each x under the triangle, eq. (3).
Numbers slopes_in_closed_form(const Surface& surface, const Numbers& x);

/// ∂u_z/∂x at each x under the surface's load, eq. (2).
std::vector<exercise::Estimate> slopes(const Surface& surface, const Numbers& x);

/// u_z at each x under the surface's load. It is zero at the datum.
Numbers displacements(const Surface& surface, const Numbers& x);

/// A_k, the displacement at k spacings from a triangle of pressure 1. It is zero at the datum.
double influence_coefficient(double contact_modulus, double spacing, double datum, double k);

struct ContactOfCylinders {
  double approach;
  double half_width;
  Numbers pressure;  ///< at the nodes
};

/// The contact of two cylinders, with displacements relative to their datum.
ContactOfCylinders contact_of(const Cylinders& cylinders);

/// The number of a pressure, and the abscissas x/a at which the surface is tested.
struct Places {
  double shape;
  Numbers xi;
};

/// The number of a pressure that is in no handout, so that a program fails if it handles only the
/// named shapes.
inline double waves(const std::string& id) {
  return 4 + 12 * own_numbers(id).poisson2;
}

inline std::string place(double xi, double shape) {
  return at("x/a", xi) + (shape < shape::fewest_waves ? at(", pressure", shape) : ", waves");
}

}  // namespace assignment
