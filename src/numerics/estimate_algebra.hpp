// SPDX-License-Identifier: GPL-3.0-or-later
// For the engine as it was, which rounds bounds upwards itself.
#pragma once

#include <cmath>
#include <limits>

#include "numerics/estimate.hpp"

namespace numerics::rounding {

inline double next_up(double x) {
  return std::nextafter(x, std::numeric_limits<double>::infinity());
}
inline double add_up(double a, double b) {
  return next_up(a + b);
}
inline double multiply_up(double a, double b) {
  return next_up(a * b);
}

}  // namespace numerics::rounding
