// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "course/assignment/assignment.hpp"
#include "course/marking/class_marks.hpp"
#include "course/marking/lateness.hpp"

namespace course {

enum class RegradeOutcome { open, granted, refused };

/// A student's request to mark one check again, and what came of it.
struct Regrade {
  std::string student;  ///< or group
  std::string check;
  std::string reason;  ///< the student's words
  RegradeOutcome outcome = RegradeOutcome::open;
  double points = 0;   ///< of the check, if it was granted
  std::string answer;  ///< the marker's words; empty while it is open
  std::string marker;  ///< who decided; empty while it is open
  std::string place;   ///< «file:line:column» of the student
};

/// Reads all files *.toml in a folder, a request each, sorted by their names. Throws
/// config::Error «file:line:column: …» for an entry that is malformed, a check that the assignment
/// does not have, points that it cannot give, and a second request for the same check; OutputError
/// for a folder that cannot be read.
std::vector<Regrade> read_regrades(const Assignment& assignment,
                                   const std::filesystem::path& folder);

/// Gives the checks of granted requests the points that were decided, and makes points, deduction
/// and mark of the student, or of all members of the group, anew. A request of somebody who has no
/// mark becomes a problem of the class.
void apply_regrades(const std::vector<Regrade>& regrades, ClassMarks& marks);

/// The requests of a student or of the student's group.
std::vector<Regrade> regrades_of(const std::vector<Regrade>& regrades, const StudentMark& student);

}  // namespace course
