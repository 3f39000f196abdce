// SPDX-License-Identifier: GPL-3.0-or-later
// 0 10 6: an endless loop for every number
#include "assignment.hpp"
double square(double) {
  for (volatile int i = 0;; i = i + 1) {
  }
}
