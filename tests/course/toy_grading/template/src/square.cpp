// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include "toy.hpp"

double square(double x) {
  // BEGIN SOLUTION
  // STUB: static_cast<void>(x);
  // STUB: return std::numeric_limits<double>::quiet_NaN();
  return x * x;
  // END SOLUTION
}
