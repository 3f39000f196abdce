// SPDX-License-Identifier: GPL-3.0-or-later
// What several of the functions that students write take and return. All numbers are in SI units.
// This header is part of the handout.
#pragma once

#include <functional>

namespace exercise {

struct Material {
  double young;    ///< E, Pa
  double poisson;  ///< ν
};

/// Any pressure p(s) on −a ≤ s ≤ a. It is zero at ±a and outside, has kinks at 0 and ±a at most, is
/// smooth elsewhere, and need not be symmetric. It is known only by its values.
struct Load {
  std::function<double(double)> pressure;  ///< p in Pa at any s in m
  double half_width;                       ///< a, m
  double unit_pressure;                    ///< p₀, Pa: the order of p's greatest value
};

/// A number and a bound of its error: the truth lies within [value − abs_error, value + abs_error].
struct Estimate {
  double value;
  double abs_error;
};

}  // namespace exercise
