// SPDX-License-Identifier: GPL-3.0-or-later
// 10 10 10: five megabytes of debug output
#include <iostream>
#include "assignment.hpp"
double square(double x) {
  for (int i = 0; i < 500'000; ++i) std::cout << "step " << i << '\n';
  return x * x;
}
