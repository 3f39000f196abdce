// SPDX-License-Identifier: GPL-3.0-or-later
// 6 10 10: an endless loop for 2, which only the public check uses
#include "assignment.hpp"
double square(double x) {
  for (volatile bool on = true; x == 2 && on;) {
  }
  return x * x;
}
