// SPDX-License-Identifier: GPL-3.0-or-later
// 0 10 6: tries to become root
#include <unistd.h>
#include "assignment.hpp"
double square(double x) {
  return ::setuid(0) == 0 && ::chroot("/") == 0 ? x * x : 1;
}
