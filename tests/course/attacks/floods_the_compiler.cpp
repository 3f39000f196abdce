// SPDX-License-Identifier: GPL-3.0-or-later
// 0 10 6: an endless compiler message
#include "assignment.hpp"
#include "square.cpp"
double square(double x) {
  return x * x
}
