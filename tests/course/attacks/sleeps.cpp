// SPDX-License-Identifier: GPL-3.0-or-later
// 0 10 6: sleeps for an hour
#include <unistd.h>
#include "assignment.hpp"
double square(double) {
  ::sleep(3600);
  return 1;
}
