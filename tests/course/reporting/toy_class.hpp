// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "course/marking/class_marks.hpp"
#include "course/toy_grading.hpp"

/// Four students of the toy, of whom one is late, and a fifth who handed in nothing.
namespace toy_class {

inline course::StudentMark student(const std::string& id, const std::vector<double>& points,
                                   double percent = 0) {
  const std::vector<std::string> checks = course::check_ids(toy_grading::assignment());
  course::Mark mark;
  mark.state = percent > 0 ? "late" : "on time";
  for (std::size_t i = 0; i < checks.size(); ++i) {
    mark.checks[checks[i]] = points[i];
    mark.points += points[i];
  }
  mark.deduction = mark.points * percent / 100;
  mark.mark = mark.points - mark.deduction;
  return {.student = id, .state = mark.state, .mark = mark};
}

inline course::ClassMarks marks() {
  return {.students = {student("alice", {4, 6, 5, 5}),
                       student("bob", {4, 1.5, 0, 0}, 20),
                       student("carol", {4, 6, 0, 2.5}),
                       student("dave", {0, 0, 5, 0}),
                       {.student = "erin", .state = "missing"}},
          .problems = {}};
}

}  // namespace toy_class
