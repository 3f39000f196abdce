// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <cstdlib>
#include <string>

#include "tested.hpp"

using course::check;
using tested::square;

void tests() {
  const std::string answer = std::to_string(square(1234));
  std::fprintf(stderr, "%s\n", answer.c_str());
  check(answer.empty(), answer);
  std::abort();
}
