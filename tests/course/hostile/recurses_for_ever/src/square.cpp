// SPDX-License-Identifier: GPL-3.0-or-later
double square(double x) {
  volatile double y = x;
  return square(y + 1) + square(y - 1);
}
