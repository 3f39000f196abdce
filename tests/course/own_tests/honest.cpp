// SPDX-License-Identifier: GPL-3.0-or-later
#include "tested.hpp"

using course::check;
using tested::square;

void tests() {
  check(square(3) == 9, "above zero");
  check(square(-3) == 9, "below zero");
  check(square(2e6) == 4e12, "far off");
}
