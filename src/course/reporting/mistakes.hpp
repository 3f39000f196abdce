// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "course/assignment/assignment.hpp"
#include "course/marking/class_marks.hpp"
#include "course/release/mistake_patterns.hpp"

namespace course {

/// A wrong solution, and the students who lost their points as it does.
struct Met {
  MistakePattern pattern;
  std::vector<std::string> students;
};

/// Who made which mistake, as far as points tell: each check of the exercises that the wrong
/// solution changes gave the student all, some or none of its points just as it gave the wrong
/// solution. (How many exactly may depend on the variant.) A student whose file of such an exercise
/// is missing or does not compile, or who has no point in such an exercise, made none. Wrong
/// solutions that lose nothing there, and others with the same pattern, cannot be told apart: each
/// of them has the same students. After them, unless there is no pattern at all, come the exercises
/// in which students have no point though nothing of theirs failed to compile, each as a pattern
/// "not done".
std::vector<Met> met_mistakes(const Assignment& assignment,
                              const std::vector<MistakePattern>& patterns, const ClassMarks& marks);

/// A table with a line for each wrong solution, and each exercise that somebody has not done.
std::string mistakes_csv(const std::vector<Met>& met);

}  // namespace course
