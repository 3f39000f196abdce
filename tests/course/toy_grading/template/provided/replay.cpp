// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/assignment/replay.hpp"

int main() {
  course::replay_tests();
  return 0;
}
