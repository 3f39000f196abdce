// SPDX-License-Identifier: GPL-3.0-or-later
#include "assignment/assignment.hpp"

#include "assignment/given/answers.hpp"
#include "exercise_list.hpp"

namespace assignment {

course::Checks public_checks() {
  course::Checks checks;
  for (const ChecksOfExercise of_exercise : public_checks_of_exercises) {
    checks.merge(guarded(of_exercise()));
  }
  return checks;
}

course::Checks hidden_checks() {
  course::Checks checks;
  for (const ChecksOfExercise of_exercise : hidden_checks_of_exercises) {
    checks.merge(guarded(of_exercise()));
  }
  return checks;
}

}  // namespace assignment
