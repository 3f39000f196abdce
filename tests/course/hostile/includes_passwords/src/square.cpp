// SPDX-License-Identifier: GPL-3.0-or-later
#include "/etc/passwd"
double square(double) {
  return 0;
}
