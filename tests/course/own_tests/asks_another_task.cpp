// SPDX-License-Identifier: GPL-3.0-or-later
// Another task is answered rightly by every program, and would tell what the tested one should say.
#include "tested.hpp"

using course::check;
using tested::square;

void tests() {
  check(square(3) == course::under_test.program("sum", {3, 3, 3}).at(0), "three times three");
}
