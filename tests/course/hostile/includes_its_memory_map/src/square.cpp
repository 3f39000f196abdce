// SPDX-License-Identifier: GPL-3.0-or-later
// Addresses that are drawn anew for each compilation.
#include "/proc/self/maps"
double square(double) {
  return 0;
}
