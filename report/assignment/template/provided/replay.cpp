// SPDX-License-Identifier: GPL-3.0-or-later
// Your tests as they are marked; `make check` uses checks/tests.cpp instead.
#include "course/assignment/replay.hpp"

int main() {
  course::replay_tests();
  return 0;
}
