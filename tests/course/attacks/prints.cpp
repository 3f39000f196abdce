// SPDX-License-Identifier: GPL-3.0-or-later
// 10 10 10: debug output, even before main()
#include <cstdio>
#include <iostream>
#include "assignment.hpp"
static const int at_start = std::printf("starting\n");
double square(double x) {
  std::printf("x = %g\n", x);
  std::cout << "x = " << x << std::endl;
  return x * x + 0 * at_start;
}
