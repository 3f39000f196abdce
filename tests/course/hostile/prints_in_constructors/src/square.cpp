// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <iostream>

#include "toy.hpp"

static const bool is_printed = [] {
  std::cout << "begins\n";
  std::puts("1");
  return true;
}();

double square(double x) {
  return x * x;
}
