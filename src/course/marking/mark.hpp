// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "course/marking/lateness.hpp"
#include "course/marking/submission.hpp"
#include "course/marking/try_checks.hpp"

namespace course {

/// Everything that grading found out about one submission.
struct Graded {
  std::string student;
  Lateness late;
  Submission submission;
  std::map<std::string, std::string> compile_errors;  ///< by exercise
  std::string link_error;
  std::vector<CheckResult> results;  ///< in the assignment's order
  /// What the student's own tests do not catch, a line each, for the instructor.
  std::vector<std::string> missed = {};
};

double deduction_of(const Graded& graded);  ///< from the sum of the points; rounded to hundredths
double mark_of(const Graded& graded);       ///< the points minus the deduction

/// "on time", which slip days may have bought, "late", or "too late".
std::string state_of(const Graded& graded);

/// "on time" or "2 days late, 1 slip day used: 10 % of the points are deducted", for students.
std::string lateness_text(const Graded& graded);

/// The result of a check; throws std::out_of_range if there is none.
const CheckResult& result_of(const Graded& graded, const std::string& check);

/// The file mark.json, which `collect` reads.
std::string mark_json(const Assignment& assignment, const Graded& graded);

/// A text for the instructor with everything, the messages of hidden checks included.
std::string log_text(const Assignment& assignment, const Graded& graded);

/// Whether a check reached all of its points.
bool is_passed(const CheckEntry& entry, const CheckResult& result);

}  // namespace course
