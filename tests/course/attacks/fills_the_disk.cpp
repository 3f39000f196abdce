// SPDX-License-Identifier: GPL-3.0-or-later
// 0 10 6: writes endlessly to files
#include <fstream>
#include <string>
#include "assignment.hpp"
double square(double) {
  for (const char* path : {"/tmp/large", "large"}) {
    std::ofstream file(path);
    while (file << std::string(1 << 20, 'x')) {
    }
  }
  return 1;
}
