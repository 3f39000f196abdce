// SPDX-License-Identifier: GPL-3.0-or-later
#include "/dev/urandom"
double square(double) {
  return 0;
}
