// SPDX-License-Identifier: GPL-3.0-or-later
#include "/dev/ptmx"
double square(double) {
  return 0;
}
