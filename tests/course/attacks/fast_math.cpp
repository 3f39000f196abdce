// SPDX-License-Identifier: GPL-3.0-or-later
// 10 10 10: -ffast-math by a pragma
#pragma GCC optimize("fast-math")
#include "assignment.hpp"
double square(double x) {
  return x * x;
}
