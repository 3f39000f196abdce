// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "course/assignment/assignment.hpp"
#include "course/marking/class_marks.hpp"
#include "course/reporting/regrades.hpp"

namespace course {

/// The page that `grade` wrote, with the student's mark of `most` points as it stands and, below,
/// what persons gave for the report, and the student's requests and what came of them. Throws
/// OutputError if it is no such page.
std::string final_feedback(const Assignment& assignment, const std::string& page, double most,
                           const StudentMark& student, const std::vector<Regrade>& regrades);

/// Writes `output`/STUDENT.html for each student who has a mark, and nothing else: no logs, no
/// results of others. What was there before is replaced as a whole. Throws OutputError if a page
/// cannot be read or written; then the old ones stay.
void release_feedback(const Assignment& assignment, const std::filesystem::path& grades,
                      const ClassMarks& marks, const std::vector<Regrade>& regrades,
                      const std::filesystem::path& output);

/// A line for each reason why feedback must not go out yet: a mark that cannot be read, or a
/// submission that was not graded.
std::vector<std::string> reasons_to_wait(const ClassMarks& marks);

}  // namespace course
