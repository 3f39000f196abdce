// SPDX-License-Identifier: GPL-3.0-or-later
double square(double x) {
#ifdef RIGHT
  return x * x;
#else
  return 0 * x;
#endif
}
