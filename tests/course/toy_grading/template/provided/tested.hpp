// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "course/assignment/own_tests.hpp"

namespace tested {

inline double square(double x) {
  const course::Numbers answer = course::under_test.program("square", {x});
  return answer.empty() ? std::numeric_limits<double>::quiet_NaN() : answer.front();
}

}  // namespace tested
