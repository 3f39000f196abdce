// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

static const struct Last {
  ~Last() { _exit(3); }
} last;

double square(double x) {
  return x * x;
}
