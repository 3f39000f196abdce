// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "course/assignment/assignment.hpp"
#include "course/marking/roster.hpp"

namespace course {

/// What `grade` found out about one submission, read from its mark.json.
struct Mark {
  std::string state;  ///< "on time", "late" or "too late"
  int slip_days = 0;  ///< days late that cost nothing and are used up
  double points = 0;
  double deduction = 0;
  double mark = 0;
  bool has_report = false;
  std::vector<std::string> missing;        ///< exercises without a file
  std::vector<std::string> not_compiling;  ///< exercises
  std::map<std::string, double> checks;    ///< the points that each gave
};

/// A student of the class; one without a mark is "missing", "not graded" or "not in the class".
struct StudentMark {
  std::string student;
  std::string state;
  std::optional<Mark> mark = {};
  std::string group = {};  ///< with which the student handed in; empty: alone

  /// The name under which the submission is graded.
  const std::string& unit() const { return group.empty() ? student : group; }
};

/// The marks of a class, and a line for each folder whose mark cannot be read.
struct ClassMarks {
  std::vector<StudentMark> students;  ///< sorted
  std::vector<std::string> problems;
};

/// Merges the folders that `grade` wrote, each named for its student or for the group whose members
/// all have its mark. Students without a mark are there as well, if they are in the roster or in
/// `submissions`: "not graded" if they handed something in ("not in the class" for those who are
/// not in the roster), and otherwise "missing". Throws OutputError if `grades` cannot be read.
ClassMarks class_marks(const Assignment& assignment, const std::filesystem::path& grades,
                       const std::optional<Roster>& roster,
                       const std::optional<std::filesystem::path>& submissions);

/// The ids of all checks, in the assignment's order.
std::vector<std::string> check_ids(const Assignment& assignment);

/// The marks of a class as a table: a header and a line for each student.
std::string marks_csv(const Assignment& assignment, const ClassMarks& marks);

}  // namespace course
