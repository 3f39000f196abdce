// SPDX-License-Identifier: GPL-3.0-or-later
#include <random>

#include "tested.hpp"

using course::check;
using tested::square;

void tests() {
  check(square(static_cast<double>(std::random_device{}())) > 0, "any");
}
