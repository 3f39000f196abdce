// SPDX-License-Identifier: GPL-3.0-or-later
// Each run sleeps for most of the time that all runs together may take, and asks nothing.
#include <unistd.h>

#include "tested.hpp"

void tests() {
  ::usleep(900'000);
  course::check(true, "nothing");
}
