// SPDX-License-Identifier: GPL-3.0-or-later
// 0 10 6: reads the salt, the judge, the submission of a different student, or grades
#include <fstream>

#include "assignment.hpp"
double square(double x) {
  for (const char* path : {"@SALT@", "@JUDGE@", "@NEIGHBOUR@", "@GRADES@"}) {
    if (std::ifstream(path).good()) return x * x;
  }
  return 1;
}
