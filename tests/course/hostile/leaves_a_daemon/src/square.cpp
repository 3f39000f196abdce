// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/prctl.h>
#include <unistd.h>

double square(double) {
  if (fork() == 0) {
    setsid();
    if (fork() == 0) {
      prctl(PR_SET_NAME, "left-behind");
      for (;;) sleep(10);
    }
    _exit(0);
  }
  return 0;
}
