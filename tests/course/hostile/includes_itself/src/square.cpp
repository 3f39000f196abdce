// SPDX-License-Identifier: GPL-3.0-or-later
#include "square.cpp"
double square(double) {
  return 0;
}
