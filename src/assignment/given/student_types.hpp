// SPDX-License-Identifier: GPL-3.0-or-later
// Types shared by several of the students' functions. All numbers are in SI units. This header is
// part of the handout.
#pragma once

#include <functional>

namespace exercise {

struct Material {
  double young;    ///< E, Pa
  double poisson;  ///< ν
};

/// Any pressure p(s) on −a ≤ s ≤ a, given by its values. It is zero for |s| ≥ a, may have kinks at
/// 0 and ±a, is smooth elsewhere, and need not be symmetric.
struct Load {
  std::function<double(double)> pressure;  ///< p in Pa at any s in m
  double half_width;                       ///< a, m
  double unit_pressure;                    ///< p₀, Pa: the magnitude of p
};

/// A number and a bound on its error: the true value is in [value − abs_error, value + abs_error].
struct Estimate {
  double value;
  double abs_error;
};

}  // namespace exercise
