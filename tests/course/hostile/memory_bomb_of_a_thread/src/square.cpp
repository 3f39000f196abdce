// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <thread>

// The children of a thread that is not the first; each stays within its own limit.
double square(double x) {
  int n_full = 0;
  std::thread([&] {
    for (int i = 0; i < 4; ++i) {
      if (fork() != 0) continue;
      char* memory = new char[200 << 20];
      std::memset(memory, 1, 200 << 20);
      usleep(700000);
      _exit(memory[i] == 1 ? 0 : 1);
    }
    for (int status = 0; wait(&status) > 0;) n_full += status == 0;
  }).join();
  return n_full == 4 ? x * x : 0;
}
