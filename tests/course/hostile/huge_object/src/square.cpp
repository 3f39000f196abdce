// SPDX-License-Identifier: GPL-3.0-or-later
int much[1 << 28] = {1};

double square(double x) {
  return x * much[0];
}
