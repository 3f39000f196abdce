// SPDX-License-Identifier: GPL-3.0-or-later
// 0 10 6: allocates all memory
#include <cstring>
#include "assignment.hpp"
double square(double) {
  for (volatile bool on = true; on;) std::memset(new char[1 << 24], 1, 1 << 24);
  return 1;
}
