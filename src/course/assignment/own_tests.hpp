// SPDX-License-Identifier: GPL-3.0-or-later
// What a student's own tests are written with. This header is part of the handout, so it uses the
// standard library only.
#pragma once

#include <functional>
#include <source_location>
#include <string>

#include "course/assignment/check.hpp"

/// What a file of tests defines: calls of course::check on what a program answers.
void tests();

namespace course {

/// The program that is tested, whose answer is empty if it has none, and what becomes of a check
/// that does not hold: main() decides of both.
struct UnderTest {
  Program program;
  std::function<void(int line, const std::string& says)> reject;
  int n_checks = 0;
};

inline UnderTest under_test;

/// Rejects the program under test unless `holds`. `says` is for who runs the tests by hand.
inline void check(bool holds, const std::string& says,
                  const std::source_location& where = std::source_location::current()) {
  ++under_test.n_checks;
  if (!holds) under_test.reject(static_cast<int>(where.line()), says);
}

}  // namespace course
