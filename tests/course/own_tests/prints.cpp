// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>

#include "tested.hpp"

using course::check;
using tested::square;

void tests() {
  std::printf("the square of 3 is %g\n", square(3));
  std::fprintf(stderr, "the square of -3 is %g\n", square(-3));
  check(square(3) == 9, "above zero");
  check(square(-3) == 9, "below zero");
  check(square(2e6) == 4e12, "far off");
}
