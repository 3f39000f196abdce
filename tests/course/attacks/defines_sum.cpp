// SPDX-License-Identifier: GPL-3.0-or-later
// 0 10 6: defines the function of a different exercise
#include "assignment.hpp"
double square(double x) {
  return x * x;
}
double sum(double, double) {
  return 1;
}
