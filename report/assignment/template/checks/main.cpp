// SPDX-License-Identifier: GPL-3.0-or-later
// build/checks [PART]: tries the public checks on your functions and prints a line for each, either
// for all or for those whose id begins with PART. The exit code is 1 if a check does not hold in
// full.
#include <gsl/gsl_errno.h>

#include <cmath>
#include <exception>
#include <iostream>
#include <string>
#include <utility>

#include "assignment.hpp"
#include "assignment/given/answers.hpp"
#include "printed_text.hpp"
#include "tasks.hpp"
#include "variant_of_this_handout.hpp"

namespace {

struct Exercise {
  std::string title;
  course::Checks (*public_checks)();
};

const Exercise exercises[] = {
    // EACH EXERCISE: {"@number@. @title@", assignment::@name@::public_checks},
};

struct Result {
  course::Outcome outcome;
  std::string printed;  // what your functions printed meanwhile
};

Result result_of(const course::Check& check) {
  const PrintedText printed;
  try {
    const course::Outcome outcome = check(run_task, this_variant);
    return {outcome, printed.beginning()};
  } catch (const std::exception& e) {
    return {{0, e.what()}, printed.beginning()};
  }
}

// Prints the outcome of the exercise's checks; true if they all hold.
bool try_exercise(const Exercise& exercise, const std::string& wanted) {
  bool all_hold = true;
  bool is_titled = false;
  for (const auto& [id, check] : assignment::guarded(exercise.public_checks())) {
    if (!id.starts_with(wanted)) continue;
    if (!std::exchange(is_titled, true)) std::cout << exercise.title << '\n';
    const auto [outcome, printed] = result_of(check);
    const auto& [share, message] = outcome;
    all_hold = all_hold && share == 1;
    std::cout << std::round(100 * share) << " %\t" << id;
    if (!message.empty()) std::cout << "\n\t" << message;
    if (!printed.empty()) {
      std::cout << "\n\tyour program printed \"" << printed
                << "\"; that costs no points, but take it out: a program that prints much is ended";
    }
    std::cout << '\n';
  }
  return all_hold;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string wanted = argc > 1 ? argv[1] : "";
  gsl_set_error_handler_off();  // as in build/assignment
  bool all_hold = true;
  for (const Exercise& exercise : exercises) {
    all_hold = try_exercise(exercise, wanted) && all_hold;
  }
  return all_hold ? 0 : 1;
}
