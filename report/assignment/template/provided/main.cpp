// SPDX-License-Identifier: GPL-3.0-or-later
// build/assignment TASK: reads numbers from standard input and prints the answer, one number a
// line. Of several questions, with a ';' between them, the last one is answered, after the others.
// With - in place of TASK each line is a question, «TASK number number …», and is answered by a
// line. Without TASK it lists the tasks. What your functions print goes to standard error and is no
// part of the answer. The exit code is 2, with a line on standard error, for an input that does not
// fit. GSL does not abort here when a quadrature fails, but returns an error code.
#include <gsl/gsl_errno.h>

#include <exception>
#include <iostream>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "course/assignment/answer_channel.hpp"
#include "tasks.hpp"

int main(int argc, char** argv) {
  gsl_set_error_handler_off();
  try {
    if (argc != 2) {
      throw std::invalid_argument("usage: assignment TASK < numbers\n" + list_of_tasks());
    }
    if (std::string_view(argv[1]) == "-") {
      course::answer_lines(std::cin, run_task);
      return 0;
    }
    std::vector<double> answer;
    for (const auto& numbers : course::read_questions(std::cin))
      answer = run_task(argv[1], numbers);
    if (course::write_answer(answer)) return 0;
    throw std::runtime_error("the answer cannot be written");
  } catch (const std::exception& e) {
    std::cerr << "assignment: " << e.what() << '\n';
    return 2;
  }
}
