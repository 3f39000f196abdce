// SPDX-License-Identifier: GPL-3.0-or-later
// How grading runs a student's own tests: apart from the program under test, of which they see
// numbers and nothing else. This header is part of the handout and is included by a file with
// main() alone.
#pragma once

#include <array>
#include <cstdio>
#include <iostream>
#include <sstream>
#include <string>

#include "course/assignment/answer_channel.hpp"
#include "course/assignment/own_tests.hpp"

namespace course {

/// «TASK number number …», with all digits.
inline std::string question_line(const std::string& task, const Numbers& inputs) {
  std::string line = task;
  for (const double input : inputs) {
    std::array<char, 32> digits{};
    std::snprintf(digits.data(), digits.size(), " %.17g", input);
    line += digits.data();
  }
  return line;
}

/// Runs the tests. Standard input holds the answers that the program under test gave to what they
/// asked in their last run, a line each, and they get these in that order, whatever they ask now:
/// the run counts if that is the same. The answer channel gets a line «? QUESTION» for each
/// question and, if the tests come to their end, «. CHECKS LINE»: how many checks there were, and
/// in which line the first stands that did not hold, or 0.
inline void replay_tests() {
  under_test.program = [](const std::string& task, const Numbers& inputs) {
    ::dprintf(answer_descriptor, "? %s\n", question_line(task, inputs).c_str());
    std::string answer;
    std::getline(std::cin, answer);
    std::istringstream words(answer);
    return numbers_in(words);
  };
  int rejecting = 0;
  under_test.reject = [&](int line, const std::string&) {
    if (rejecting == 0) rejecting = line;
  };
  tests();
  ::dprintf(answer_descriptor, ". %d %d\n", under_test.n_checks, rejecting);
}

}  // namespace course
