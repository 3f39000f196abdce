// SPDX-License-Identifier: GPL-3.0-or-later
#include "tested.hpp"

void tests() {
  // BEGIN SOLUTION
  course::check(tested::square(-3) == 9, "below zero");
  // END SOLUTION
}
