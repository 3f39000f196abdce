// SPDX-License-Identifier: GPL-3.0-or-later
#include "tested.hpp"

using course::check;
using tested::square;

void tests() {
  check(square(2) == 4, "two");
  check(square(0.5) == 0.25, "a half");
}
