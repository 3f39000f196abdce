// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "elasticity/stress.hpp"

namespace line_contact {

/// A point of the body with its greatest shear.
struct ShearPoint {
  double x;      ///< a length
  double z;      ///< a length, into the body
  double shear;  ///< τ₁, a stress
};

/// Finds where τ₁ is greatest in |x| ≤ 1.2a and least_depth ≤ z ≤ 1.6a, a the half-width of the
/// contact, by the best point of a grid and then of finer and finer grids around it.
///
/// `stress` gives the stress at (x, z). Accuracy: the last steps are 1e-7 a, but a shear that is
/// flat at its maximum tells the place only to the root of its own error. The search needs one
/// maximum that is wider than the first steps, 0.12a across and 0.08a down.
/// Throws InvalidQuantity unless half_width and least_depth are positive.
ShearPoint find_greatest_shear(const std::function<elasticity::Stress(double x, double z)>& stress,
                               double half_width, double least_depth);

}  // namespace line_contact
