// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "judge/check.hpp"

namespace judge {

/// The checks and numbers of an assignment.
struct Assignment {
  /// Returns the exercises with their checks, for the numbers that follow from a student's id and
  /// the salt that determines the numbers of the hidden checks. An empty one means the nominal
  /// numbers.
  std::function<std::vector<Exercise>(const std::string& student, const std::string& salt)>
      exercises;
  /// Returns the numbers that follow from a student's id, one line "name value unit" per number.
  std::function<std::string(const std::string& student)> numbers;
};

/// The main() of a judge:
///
///   --check ID -- PROGRAM…             runs one public check and prints what does not hold
///   --exercise ID --public -- PROGRAM… runs the public checks of an exercise (or --hidden). Prints
///                                      a line "ID share message" per check, separated by tabs, and
///                                      then "used SECONDS ANSWERS": the time that the program took
///                                      for its answers, and their number
///   --numbers                          prints the student's numbers
///
/// Options are --student ID, --salt-file FILE, and --allowance SECONDS, the time limit for all
/// questions. PROGRAM is the command that starts the student's program. Exit codes: 0 success, 1
/// the check does not hold, 3 the judge failed.
int run(int argc, char** argv, const Assignment& assignment);

}  // namespace judge
