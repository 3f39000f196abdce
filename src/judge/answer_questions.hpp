// SPDX-License-Identifier: GPL-3.0-or-later
// The loop in which a student's program answers questions. This header is part of the handout; only
// the file with main() includes it.
#pragma once

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace judge {

/// The descriptor to which answers are written: standard output as it was at program start.
inline int answer_descriptor = -1;

/// Redirects standard output to standard error, so that forgotten debug output does no harm. This
/// runs before the constructors of static objects.
__attribute__((constructor(101))) inline void reserve_output_for_answers() {
  if (answer_descriptor >= 0) return;
  answer_descriptor = ::dup(STDOUT_FILENO);
  ::dup2(STDERR_FILENO, STDOUT_FILENO);
}

/// Answers each line of standard input, "TASK number number …", with a line of numbers, printed
/// with all digits of a double. `run` computes the answer from the task and its inputs; if it
/// throws, the line is empty and the reason goes to standard error.
template <class Run>
void answer_questions(const Run& run) {
  std::FILE* const answers = ::fdopen(answer_descriptor, "w");
  for (std::string line; std::getline(std::cin, line);) {
    std::istringstream words(line);
    std::string task;
    words >> task;
    std::vector<double> inputs;
    for (std::string word; words >> word;) inputs.push_back(std::strtod(word.c_str(), nullptr));
    std::vector<double> answer;
    try {
      answer = run(task, inputs);
    } catch (const std::exception& e) {
      std::cerr << "no answer: " << e.what() << std::endl;
    }
    for (const double number : answer) std::fprintf(answers, "%.17g ", number);
    std::fprintf(answers, "\n");
    std::fflush(answers);
  }
}

}  // namespace judge
