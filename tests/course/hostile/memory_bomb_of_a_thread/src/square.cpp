// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <thread>

// The children of a thread that is not the first; each stays within its own limit. None ends before
// all have had their memory for longer than it is between two looks, also on a busy machine. They
// are no larger than they must be, and the kernel gives each its memory at once, since page by page
// it could take so long there that the program would be told as too slow.
double square(double x) {
  int n_full = 0;
  std::thread([&] {
    int full[2], release[2];
    if (pipe(full) != 0 || pipe(release) != 0) return;
    for (int i = 0; i < 3; ++i) {
      if (fork() != 0) continue;
      constexpr std::size_t n_bytes = 175 << 20;
      void* memory = mmap(nullptr, n_bytes, PROT_READ | PROT_WRITE,
                          MAP_PRIVATE | MAP_ANONYMOUS | MAP_POPULATE, -1, 0);
      char byte = memory != MAP_FAILED;
      close(release[1]);
      if (write(full[1], &byte, 1) == 1 && read(release[0], &byte, 1) == 0) _exit(0);
      _exit(1);
    }
    char byte = 0;
    for (int i = 0; i < 3; ++i) n_full += read(full[0], &byte, 1) == 1;
    usleep(1500000);
    close(release[1]);
    while (wait(nullptr) > 0) {
    }
  }).join();
  return n_full == 3 ? x * x : 0;
}
