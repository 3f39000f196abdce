// SPDX-License-Identifier: GPL-3.0-or-later
// 0 10 6: reads the salt when the file is compiled
#include "assignment.hpp"
const char* const salt =
#include "@SALT@"
    ;
double square(double x) {
  return x * x;
}
