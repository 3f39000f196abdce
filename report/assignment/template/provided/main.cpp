// SPDX-License-Identifier: GPL-3.0-or-later
// build/assignment reads questions from standard input, each a line "TASK number number …", and
// answers each with a line of numbers. Output of your functions goes to standard error and is not
// part of the answer. build/assignment --list lists the tasks.
#include <gsl/gsl_errno.h>

#include <stdexcept>
#include <string>

#include "judge/answer_questions.hpp"
#include "tasks.hpp"

namespace {

judge::Numbers answer(const std::string& task, const judge::Numbers& inputs) {
  for (const assignment::Task& known : tasks()) {
    if (known.name != task) continue;
    if (inputs.size() >= known.n_inputs) return known.run(inputs);
    throw std::invalid_argument("task " + task + " takes " + known.takes);
  }
  throw std::invalid_argument("unknown task " + task);
}

}  // namespace

int main(int argc, char**) {
  gsl_set_error_handler_off();  // otherwise a failed quadrature would end the program
  if (argc > 1) {
    for (const assignment::Task& task : tasks()) {
      std::cerr << task.name << ": " << task.takes << " → " << task.gives << '\n';
    }
    return 0;
  }
  judge::answer_questions(answer);
  return 0;
}
