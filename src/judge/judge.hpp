// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "judge/check.hpp"

namespace judge {

/// The main() of a judge of these exercises:
///
///   --check ID --student ID -- PROGRAM…     runs one public check
///   --exercise ID --student ID -- PROGRAM…  runs the public checks of an exercise
///   --exercise ID --salt FILE -- PROGRAM…   runs the hidden checks of an exercise, with the
///   numbers
///                                           that follow from the contents of a file
///   --numbers ID                            prints what `numbers` returns for a student's id
///
/// PROGRAM is the command that starts the student's program, and --seconds N the time limit for all
/// questions. Prints a line "ID share message" for each check, separated by tabs. Exit codes: 0 all
/// checks hold, 1 one does not, 3 the judge failed.
int run(int argc, char** argv, const std::vector<Exercise>& exercises,
        std::string (*numbers)(const std::string& student));

}  // namespace judge
