// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <iostream>

// Lines that were left over from the search for an error: they are no part of the answer.
static const bool is_told = (std::cout << "this is square.cpp" << std::endl).good();

double square(double x) {
  std::cout << "x = " << x << std::endl;
  std::printf("%g squared\n", x);
  return is_told ? x * x : 0;
}
