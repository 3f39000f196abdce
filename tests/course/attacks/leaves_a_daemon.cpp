// SPDX-License-Identifier: GPL-3.0-or-later
// 0 10 6: leaves a process behind
#include <sys/prctl.h>
#include <unistd.h>
#include "assignment.hpp"
double square(double) {
  if (::fork() == 0) {
    ::setsid();
    if (::fork() != 0) ::_exit(0);
    ::prctl(PR_SET_NAME, "left-behind");
    for (int i = 0; i < 20; ++i) ::close(i);
    ::sleep(600);
  }
  return 1;
}
