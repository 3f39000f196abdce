// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "numerics/estimate.hpp"

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "error bounds and digits need IEEE arithmetic: compile without -ffast-math and -Ofast"
#endif

namespace literate {

/// A number with its bound and its standard uncertainty, all in one unit.
///
/// The true number lies within `bound` of a number distributed about `value` with the standard
/// deviation `standard`. Computations have a bound, measurements and fits a standard uncertainty
/// (JCGM 100:2008, 2.3.1), and results computed from measurements may have both. An exact number
/// has neither.
struct Number {
  Number(double number, double error_bound, double standard_uncertainty = 0)
      : value(number), bound(error_bound), standard(standard_uncertainty) {}
  // NOLINTNEXTLINE(google-explicit-constructor): a computation returns estimates
  Number(numerics::Estimate estimate) : value(estimate.value), bound(estimate.abs_error) {}

  bool is_exact() const { return bound == 0 && standard == 0; }

  double value;
  double bound;         ///< ≥ 0
  double standard = 0;  ///< ≥ 0
};

}  // namespace literate
