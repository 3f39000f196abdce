// SPDX-License-Identifier: GPL-3.0-or-later
static const struct Last {
  ~Last() {
    for (;;) {
    }
  }
} last;

double square(double x) {
  return x * x;
}
