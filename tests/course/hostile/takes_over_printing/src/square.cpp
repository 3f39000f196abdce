// SPDX-License-Identifier: GPL-3.0-or-later
extern "C" int dprintf(int, const char*, ...) {
  return 1;
}

double square(double x) {
  return x * x;
}
