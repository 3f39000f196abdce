// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

double square(double x) {
  sleep(60);
  return x * x;
}
