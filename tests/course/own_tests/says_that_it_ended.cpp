// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <cstdlib>

#include "course/assignment/answer_channel.hpp"
#include "tested.hpp"

using course::check;
using tested::square;

void tests() {
  ::dprintf(course::answer_descriptor, "? square 2\n. 5 0\n");
  std::_Exit(0);
}
