// SPDX-License-Identifier: GPL-3.0-or-later
// 10 10 10: four threads
#include <thread>
#include <vector>
#include "assignment.hpp"
double square(double x) {
  double parts[4];
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) threads.emplace_back([&, i] { parts[i] = x * x / 4; });
  for (std::thread& thread : threads) thread.join();
  return parts[0] + parts[1] + parts[2] + parts[3];
}
