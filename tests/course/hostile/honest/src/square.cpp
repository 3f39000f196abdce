// SPDX-License-Identifier: GPL-3.0-or-later
#include "toy.hpp"

double square(double x) {
  return x * x;
}
