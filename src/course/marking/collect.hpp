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
  std::string csv;  ///< a header and a line for each student, sorted
  std::vector<std::string> problems;
};

/// Merges the folders that `grade` wrote, each named for its student. Students without a mark
/// get a line as well, if they are in the roster or in `submissions`: "not graded" if they handed
/// something in ("not in the class" for those who are not in the roster), and otherwise "missing".
/// Throws OutputError if `grades` cannot be read.
Grades collect_grades(const Assignment& assignment, const std::filesystem::path& grades,
                      const std::optional<Roster>& roster,
                      const std::optional<std::filesystem::path>& submissions);

}  // namespace course
