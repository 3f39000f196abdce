// SPDX-License-Identifier: GPL-3.0-or-later
// 0 10 6: a correct answer to every question, after nine seconds
#include <unistd.h>
#include "assignment.hpp"
double square(double x) {
  ::sleep(9);
  return x * x;
}
