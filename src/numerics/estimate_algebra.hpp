// SPDX-License-Identifier: GPL-3.0-or-later
// Products, quotients and functions of numbers with bounds.
#pragma once

#include "numerics/estimate.hpp"

namespace numerics {

/// Each operation returns an Estimate that holds the true result for all true numbers that its
/// operands hold: bounds are rounded upwards, and the rounding of the value itself is part of them.
/// The operands are taken to be independent, so x/x has twice the relative error of x. A plain
/// number is exact. Throws InvalidQuantity where the result or its bound is no finite number.
Estimate operator*(Estimate a, Estimate b);
Estimate operator*(Estimate a, double b);

/// a/b. Throws InvalidQuantity where b may be zero.
Estimate operator/(Estimate a, Estimate b);
Estimate operator/(Estimate a, double b);
Estimate operator/(double a, Estimate b);

Estimate operator+(Estimate a, double b);
Estimate operator+(double a, Estimate b);
Estimate operator-(Estimate a, double b);
Estimate operator-(double a, Estimate b);

/// Throws InvalidQuantity where a may be negative.
Estimate sqrt(Estimate a);

/// aᵖ. Throws InvalidQuantity where a may be zero or negative, unless p is a whole number above
/// zero.
Estimate pow(Estimate a, double p);

Estimate exp(Estimate a);

/// The natural logarithm. Throws InvalidQuantity where a may be zero or negative.
Estimate log(Estimate a);

/// Of an angle in radians, as `cos`.
Estimate sin(Estimate a);
Estimate cos(Estimate a);

Estimate atan(Estimate a);

/// |a|, as wrong as a.
Estimate abs(Estimate a);

/// The greater of two, as wrong as the worse known of them.
Estimate max(Estimate a, Estimate b);

}  // namespace numerics
