// SPDX-License-Identifier: GPL-3.0-or-later
// 6 10 10: a crash for 2, which the public check alone asks for
#include <cstdlib>
#include "assignment.hpp"
double square(double x) {
  if (x == 2) std::abort();
  return x * x;
}
