// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "judge/check.hpp"

namespace judge {

/// What a judge knows of an assignment.
struct Assignment {
  /// The exercises with their checks, for a student's own numbers and the salt from which hidden
  /// checks draw theirs. Both are empty for the nominal numbers.
  std::function<std::vector<Exercise>(const std::string& student, const std::string& salt)>
      exercises;
  /// A student's own numbers, one "name value unit" a line.
  std::function<std::string(const std::string& student)> numbers;
};

/// The main() of a judge:
///
///   --check ID -- PROGRAM…             runs one public check and says what does not hold
///   --exercise ID --public -- PROGRAM… runs the public checks of an exercise (or --hidden); prints
///                                      "ID share message" for each, with tabs between, and then
///                                      "lost SECONDS ANSWERS": how long questions without an
///                                      answer took, and how many were answered
///   --numbers                          prints the student's own numbers
///
/// with --student ID, --salt-file FILE, and --allowance SECONDS for questions without an answer.
/// PROGRAM is the command that starts the student's program. Exit code: 0, 1 if the one check does
/// not hold, 3 if the judge itself fails.
int run(int argc, char** argv, const Assignment& assignment);

}  // namespace judge
