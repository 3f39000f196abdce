// SPDX-License-Identifier: GPL-3.0-or-later
#include "tested.hpp"

using course::check;
using tested::square;

void tests() {
  double x = 1;
  while (!(square(x) > 100)) x *= 2;
  check(x == 16, "the first power of two whose square is above 100");
}
