// SPDX-License-Identifier: GPL-3.0-or-later
namespace course {
int answer_descriptor = 1;
}

double square(double x) {
  return x * x;
}
