// SPDX-License-Identifier: GPL-3.0-or-later
#include "tested.hpp"

using course::check;
using tested::square;

void tests() {
  double x = 3;
  for (int i = 0; i < 4; ++i) x = square(x) / 3;  // stays at 3
  check(x == 3, "above zero");
  check(square(-x) == 9, "below zero");
  check(square(1e6 * x) == 9e12, "far off");
}
