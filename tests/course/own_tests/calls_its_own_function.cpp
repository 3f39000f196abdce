// SPDX-License-Identifier: GPL-3.0-or-later
#include "tested.hpp"

using course::check;

double square(double x);
void tests() {
  check(::square(3) == 9, "three");
}
