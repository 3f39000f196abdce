// SPDX-License-Identifier: GPL-3.0-or-later
// Hundred-digit arithmetic for reference values: the paper's formulas without rearrangement, so
// that a test does not repeat the mistake that it is to find.
#pragma once

#include <mpreal.h>

using Precise = mpfr::mpreal;

inline const bool has_a_hundred_digits =
    (mpfr::mpreal::set_default_prec(mpfr::digits2bits(100)), true);

/// tⁿ ln|t|, 0 at t = 0.
inline Precise power_log(const Precise& t, int n) {
  if (t == 0) return 0;
  return pow(t, n) * log(abs(t));
}

/// ∂u_z/∂x in units of −K/a: the bracket of eq. (3)'s derivative at ξ.
inline Precise precise_gradient_bracket(const Precise& xi) {
  return power_log(xi + 1, 1) + power_log(xi - 1, 1) - 2 * power_log(xi, 1);
}

/// u_z − C in units of −K/2: the bracket of eq. (3) at ξ.
inline Precise precise_displacement_bracket(const Precise& xi) {
  return power_log(xi + 1, 2) + power_log(xi - 1, 2) - 2 * power_log(xi, 2);
}
