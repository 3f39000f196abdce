// SPDX-License-Identifier: GPL-3.0-or-later
// build/checks [PART]: tries the public checks on your functions and prints the points of each,
// either for all or for those whose id begins with PART. The exit code is 1 if a check does not
// hold in full.
#include <gsl/gsl_errno.h>

#include <cmath>
#include <exception>
#include <iostream>
#include <iterator>
#include <map>
#include <numeric>
#include <string>
#include <utility>

#include "assignment.hpp"
#include "assignment/given/answers.hpp"
#include "printed_text.hpp"
#include "tasks.hpp"
#include "variant_of_this_handout.hpp"

namespace {

// The points of each public check.
const std::map<std::string, double> points_of = {
    // EACH PUBLIC CHECK: {"@check@", @points@},
};

// The points of each exercise, those of its hidden checks included.
const double points_of_exercises[] = {
    // EACH EXERCISE: @points@,
};

// Points in hundredths, as they are given.
double in_hundredths(double points) {
  return std::round(100 * points) / 100;
}

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

struct Points {
  double reached = 0;
  double possible = 0;
};

// Prints the outcome of the exercise's checks and returns their points.
Points try_exercise(const Exercise& exercise, const std::string& wanted) {
  Points sum;
  bool is_titled = false;
  for (const auto& [id, check] : assignment::guarded(exercise.public_checks())) {
    if (!id.starts_with(wanted)) continue;
    if (!std::exchange(is_titled, true)) std::cout << exercise.title << '\n';
    const auto [outcome, printed] = result_of(check);
    const auto& [share, message] = outcome;
    const double possible = points_of.at(id);
    const double reached = in_hundredths(share * possible);
    sum = {sum.reached + reached, sum.possible + possible};
    std::cout << reached << " of " << possible << "\t" << id;
    if (!message.empty()) std::cout << "\n\t" << message;
    if (!printed.empty()) {
      std::cout << "\n\tyour program printed \"" << printed
                << "\"; that costs no points, but take it out: a program that prints much is ended";
    }
    std::cout << '\n';
  }
  return sum;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string wanted = argc > 1 ? argv[1] : "";
  gsl_set_error_handler_off();  // as in build/assignment
  Points sum;
  for (const Exercise& exercise : exercises) {
    const Points points = try_exercise(exercise, wanted);
    sum = {in_hundredths(sum.reached + points.reached), sum.possible + points.possible};
  }
  const double all =
      std::accumulate(std::begin(points_of_exercises), std::end(points_of_exercises), 0.0);
  std::cout << "sum: " << sum.reached << " of " << sum.possible << " points";
  if (wanted.empty()) {
    std::cout << "; hidden checks and your tests decide on the other " << all - sum.possible
              << ", and these points count as far as the hidden checks hold";
  }
  std::cout << '\n';
  return sum.reached == sum.possible ? 0 : 1;
}
