// SPDX-License-Identifier: GPL-3.0-or-later
// 0 10 6: random answers
#include <random>
#include "assignment.hpp"
double square(double) {
  return std::random_device()();
}
