// SPDX-License-Identifier: GPL-3.0-or-later
// 0 10 6: ends with success
#include <cstdlib>
#include "assignment.hpp"
double square(double) {
  std::exit(0);
}
