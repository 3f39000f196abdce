// SPDX-License-Identifier: GPL-3.0-or-later
// 0 10 0: a static object hangs
#include "assignment.hpp"
static const int value = [] {
  for (volatile int i = 0;; i = i + 1) {
  }
  return 0;
}();
double square(double x) {
  return x * x + 0 * value;
}
