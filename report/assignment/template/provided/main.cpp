// SPDX-License-Identifier: GPL-3.0-or-later
// build/assignment answers questions, each a line "TASK number number …" on standard input, with a
// line of numbers. What your functions print goes to standard error and is no part of the answer.
// build/assignment --list lists the tasks.
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
  throw std::invalid_argument("there is no task " + task);
}

}  // namespace

int main(int argc, char**) {
  gsl_set_error_handler_off();  // a quadrature that fails returns an error code
  if (argc > 1) {
    for (const assignment::Task& task : tasks()) {
      std::cerr << task.name << ": " << task.takes << " → " << task.gives << '\n';
    }
    return 0;
  }
  judge::answer_questions(answer);
  return 0;
}
