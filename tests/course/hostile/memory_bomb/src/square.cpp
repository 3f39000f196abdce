// SPDX-License-Identifier: GPL-3.0-or-later
double square(double x) {
  for (;;) {
    volatile char* much = new char[1 << 26];
    much[17] = 1;
    x += much[17];
  }
}
