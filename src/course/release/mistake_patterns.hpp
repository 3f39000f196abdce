// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "course/assignment/assignment.hpp"
#include "course/release/wrong_solutions.hpp"

namespace course {

/// What a wrong solution does to the points, by which the same mistake is found in a class.
struct MistakePattern {
  std::string id;
  std::string says;
  std::vector<std::string> exercises;    ///< ids of those whose files it changes
  std::map<std::string, double> points;  ///< of every check, with the nominal numbers
};

/// The ids of the exercises whose files a wrong solution changes, in the assignment's order.
std::vector<std::string> changed_exercises(const Assignment& assignment,
                                           const WrongSolution& wrong);

/// The patterns as a file, which the proof of a handout writes.
std::string patterns_json(const std::vector<MistakePattern>& patterns);

/// Reads such a file. Throws OutputError naming a file that cannot be read, or that is not of this
/// assignment's exercises and checks.
std::vector<MistakePattern> read_patterns(const Assignment& assignment,
                                          const std::filesystem::path& file);

}  // namespace course
