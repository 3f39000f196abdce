// SPDX-License-Identifier: GPL-3.0-or-later
#include <sched.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <csignal>

// A child whose parent is the parent of this process, and which takes no notice of signals.
double square(double) {
  if (syscall(SYS_clone, CLONE_PARENT, nullptr, nullptr, nullptr, nullptr) == 0) {
    setsid();
    for (int signal = 1; signal < 65; ++signal) std::signal(signal, SIG_IGN);
    prctl(PR_SET_NAME, "left-behind");
    for (;;) sleep(10);
  }
  return 0;
}
