// SPDX-License-Identifier: GPL-3.0-or-later
// The correct answers, computed by the mechanics of this project. The hidden checks compare with
// them.
#pragma once

#include "assignment/given/bodies.hpp"
#include "assignment/given/student_types.hpp"
#include "judge/check.hpp"

namespace assignment {

/// ∂u_z/∂x at each x under the triangle, eq. (3).
judge::Numbers slopes_in_closed_form(const Surface& surface, const judge::Numbers& x);

/// ∂u_z/∂x at each x under the surface's load, eq. (2).
std::vector<exercise::Estimate> slopes(const Surface& surface, const judge::Numbers& x);

/// u_z at each x under the surface's load. It is zero at the datum.
judge::Numbers displacements(const Surface& surface, const judge::Numbers& x);

/// A_k, the displacement at k spacings from a triangle of pressure 1. It is zero at the datum.
double influence_coefficient(double contact_modulus, double spacing, double datum, double k);

struct ContactOfCylinders {
  double approach;
  double half_width;
  judge::Numbers pressure;  ///< at the nodes
};

/// The contact of two cylinders, with displacements relative to their datum.
ContactOfCylinders contact_of(const Cylinders& cylinders);

}  // namespace assignment
