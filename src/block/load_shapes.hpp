// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "elasticity/load.hpp"

namespace block {

/// p(x) = peak·[1 − (1 − edge_fraction)|x|/a] for |x| ≤ a: a pressure that falls linearly from its
/// peak in the middle to edge_fraction·peak at the ends. 0 is the triangle of eq. (4), 1 uniform.
///
/// peak (stress) and half_width a (length) > 0, edge_fraction ≥ 0; InvalidQuantity otherwise.
elasticity::Load linear_fall(double peak, double edge_fraction, double half_width);

/// Hertz's p(x) = peak·√(1 − (x/a)²). Resultant (π/2)·peak·a.
elasticity::Load elliptic(double peak, double half_width);

/// p(x) = peak·(1 − |x/a|ᵐ), m > 0: the triangle for m = 1, a parabola for 2, the quartic for 4.
/// Resultant 2m/(m + 1)·peak·a. Unless m is an even number the middle counts as a kink.
elasticity::Load power_fall(double peak, double exponent, double half_width);

/// p(x) = peak·(1 + cos(πx/a))/2: a fall that is steepest at a/2 and level in the middle and at the
/// ends. Resultant peak·a.
elasticity::Load cosine_fall(double peak, double half_width);

/// The load with all its tractions and forces multiplied by a finite factor.
elasticity::Load scaled(const elasticity::Load& load, double factor);

/// ∫ p dx and the concentrated forces, force per unit thickness; exact to 1e-12 of the load's
/// scale.
double normal_resultant(const elasticity::Load& load);

}  // namespace block
