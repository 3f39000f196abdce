// SPDX-License-Identifier: GPL-3.0-or-later
double square(double x) {
  volatile bool forever = true;
  while (forever) x += 1;
  return x;
}
