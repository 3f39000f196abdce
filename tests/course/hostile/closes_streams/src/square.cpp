// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

double square(double x) {
  for (int i = 0; i < 64; ++i) close(i);
  return x * x;
}
