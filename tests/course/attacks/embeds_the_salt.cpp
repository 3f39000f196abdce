// SPDX-License-Identifier: GPL-3.0-or-later
// 0 10 6: reads the salt when the file is assembled
#include "assignment.hpp"
__asm__(".incbin \"@SALT@\"");
double square(double x) {
  return x * x;
}
