// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "course/assignment/assignment.hpp"
#include "course/marking/class_marks.hpp"

namespace course {

/// The marks for Moodle's «Grades, Import, CSV file»: the columns student, grade and feedback, and
/// a line for each student who has a mark. The feedback is the points of each exercise.
std::string moodle_csv(const Assignment& assignment, const ClassMarks& marks);

/// A gradebook with the marks in it, and a line for each mark that found no place.
struct FilledGradebook {
  std::string csv;
  std::vector<std::string> problems;
};

/// The marks for Canvas, which takes only what it exported itself: `exported` is that file, named
/// `file`. A student's id is the column `SIS Login ID` or `SIS User ID`. The marks go to the column
/// `column`; an empty name stands for the one that begins with the assignment's title and " (".
/// Students without a mark keep an empty field, which changes nothing.
/// Throws sys::SourceError «file:line:column: …» for a file that is no such export, or without such
/// a column.
FilledGradebook canvas_csv(const Assignment& assignment, const ClassMarks& marks,
                           std::string_view exported, const std::string& file,
                           const std::string& column);

}  // namespace course
