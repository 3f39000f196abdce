// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/reporting/mistakes.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "course/marking/solution_trial.hpp"
#include "system/csv.hpp"

namespace course {
namespace {

enum class Part { none, some, all };

Part part_of(const CheckEntry& check, double points) {
  if (are_same_points(points, check.points)) return Part::all;
  return are_same_points(points, 0) ? Part::none : Part::some;
}

bool holds(const std::vector<std::string>& list, const std::string& text) {
  return std::ranges::find(list, text) != list.end();
}

/// Whether none of an exercise's checks gave a point.
bool has_no_point(const Exercise& exercise, const Mark& mark) {
  return std::ranges::all_of(exercise.checks, [&](const CheckEntry& check) {
    return are_same_points(mark.checks.at(check.id), 0);
  });
}

bool is_met(const Assignment& assignment, const MistakePattern& pattern, const Mark& mark) {
  bool loses = false;
  for (const Exercise& exercise : assignment.exercises) {
    if (!holds(pattern.exercises, exercise.id)) continue;
    if (holds(mark.missing, exercise.id) || holds(mark.not_compiling, exercise.id)) return false;
    if (has_no_point(exercise, mark)) return false;
    for (const CheckEntry& check : exercise.checks) {
      const Part part = part_of(check, pattern.points.at(check.id));
      if (part_of(check, mark.checks.at(check.id)) != part) return false;
      loses = loses || part != Part::all;
    }
  }
  return loses;
}

/// Who has no point in an exercise, although the file that was handed in, if any, compiles.
Met not_done(const Exercise& exercise, const ClassMarks& marks) {
  Met none{.pattern = {.id = "not done",
                       .says = "no point in " + exercise.id,
                       .exercises = {exercise.id},
                       .points = {}},
           .students = {}};
  for (const StudentMark& student : marks.students) {
    if (!student.mark || holds(student.mark->not_compiling, exercise.id)) continue;
    if (has_no_point(exercise, *student.mark)) none.students.push_back(student.student);
  }
  return none;
}

}  // namespace

std::vector<Met> met_mistakes(const Assignment& assignment,
                              const std::vector<MistakePattern>& patterns,
                              const ClassMarks& marks) {
  std::vector<Met> all;
  for (const MistakePattern& pattern : patterns) {
    Met met{.pattern = pattern, .students = {}};
    for (const StudentMark& student : marks.students) {
      if (student.mark && is_met(assignment, pattern, *student.mark)) {
        met.students.push_back(student.student);
      }
    }
    all.push_back(std::move(met));
  }
  if (patterns.empty()) return all;
  for (const Exercise& exercise : assignment.exercises) {
    Met none = not_done(exercise, marks);
    if (!none.students.empty()) all.push_back(std::move(none));
  }
  return all;
}

std::string mistakes_csv(const std::vector<Met>& all) {
  std::string csv = "wrong solution,says,exercises,students,who\r\n";
  for (const Met& met : all) {
    csv += fmt::format(
        "{},{},{},{},{}\r\n", sys::spreadsheet_field(met.pattern.id),
        sys::spreadsheet_field(met.pattern.says),
        sys::spreadsheet_field(fmt::format("{}", fmt::join(met.pattern.exercises, " "))),
        met.students.size(),
        sys::spreadsheet_field(fmt::format("{}", fmt::join(met.students, " "))));
  }
  return csv;
}

}  // namespace course
