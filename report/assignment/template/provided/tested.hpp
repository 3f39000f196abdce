// SPDX-License-Identifier: GPL-3.0-or-later
// What your tests are written with: `check(holds, "what must hold")`, and the function under test.
// They reach nothing else of your program: in marking they try programs that are not yours, of which
// they get the answers only.
#pragma once

#include <limits>

#include "course/assignment/own_tests.hpp"

namespace tested {

using course::check;

/// The influence coefficient A_k as the program under test computes it; see
/// exercise::influence_coefficient. A program that gives no answer gives NaN.
inline double influence_coefficient(double contact_modulus, double spacing, double datum, int k) {
  const course::Numbers answer = course::under_test.program(
      "influence", {contact_modulus, spacing, datum, static_cast<double>(k)});
  return answer.empty() ? std::numeric_limits<double>::quiet_NaN() : answer.front();
}

}  // namespace tested
