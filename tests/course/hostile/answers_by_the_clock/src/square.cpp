// SPDX-License-Identifier: GPL-3.0-or-later
#include <ctime>

double square(double x) {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return x * x + 1e-9 * static_cast<double>(now.tv_nsec);
}
