// SPDX-License-Identifier: GPL-3.0-or-later
// 0 10 0: a static object crashes
#include <cstdlib>

#include "assignment.hpp"
static const int value = (std::abort(), 0);
double square(double x) {
  return x * x + value;
}
