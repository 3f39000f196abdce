// SPDX-License-Identifier: GPL-3.0-or-later
// 0 10 6: an exception for every number
#include <stdexcept>
#include "assignment.hpp"
double square(double) {
  throw std::runtime_error("not written yet");
}
