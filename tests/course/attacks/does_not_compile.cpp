// SPDX-License-Identifier: GPL-3.0-or-later
// 0 10 6: the file does not compile
#include "assignment.hpp"
double square(double x) {
  return x * x
}
