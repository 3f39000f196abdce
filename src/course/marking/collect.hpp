// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "course/assignment/assignment.hpp"
#include "course/marking/roster.hpp"

namespace course {

/// The marks of a class as a table, and a line for each folder whose mark cannot be read.
struct Grades {
  std::string csv;  ///< a line a student, sorted, with a header
  std::vector<std::string> problems;
};

/// Merges the folders that `course grade` wrote, each named for its student. Students of the
/// roster, or with something in `submissions`, and without a mark get a line too: "not graded" if
/// they handed something in ("not in the class" for those who are not), else "missing". Throws
/// OutputError if `grades` cannot be read.
Grades collect_grades(const Assignment& assignment, const std::filesystem::path& grades,
                      const std::optional<Roster>& roster,
                      const std::optional<std::filesystem::path>& submissions);

}  // namespace course
