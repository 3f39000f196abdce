// SPDX-License-Identifier: GPL-3.0-or-later
// Exercise 3: the displacement from a datum. This header is part of the handout.
#pragma once

#include "assignment/given/student_types.hpp"

namespace exercise {

/// u_z of the surface under any load, zero at x = datum (and, if p is symmetric, at −datum):
/// eq. (2) integrated from the datum, or with the order of integration exchanged
///
///   u_z(x) = −[2(1−ν²)/(πE)] ∫ p(s) ln|(x−s)/(datum−s)| ds over −a ≤ s ≤ a,
///
/// by numerical integration. Must be accurate to 10⁻⁸ p₀a/E for any x and datum, including those
/// under the load.
double normal_displacement(const Material& material, const Load& load, double datum, double x);

}  // namespace exercise
