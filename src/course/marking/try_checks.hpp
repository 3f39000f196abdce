// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "course/assignment/assignment.hpp"
#include "course/assignment/check.hpp"
#include "course/marking/build.hpp"
#include "course/marking/program_run.hpp"

namespace course {

/// The points that a check gave, and the message to go with them.
struct CheckResult {
  std::string id;
  double points = 0;  ///< reached, before any deduction
  std::string message;
};

/// Tries every check of the assignment on a program, and returns the results in the assignment's
/// order. All public checks are tried first, then `after_public` is called, and the hidden checks
/// and the student's own tests come last: so whatever a student is shown of public checks and
/// pictures was computed before the program heard a hidden question.
///
/// A public check counts only as far as the hidden checks of its exercise hold: if these give the
/// share h of their points, it gives the share h of its own at most. Numbers that agree with each
/// other and with nothing else would have most of the public points otherwise. An exercise without
/// hidden checks counts as its public ones hold.
///
/// Throws std::logic_error for a check that `checks` does not hold.
std::vector<CheckResult> try_checks(const Assignment& assignment, const Checks& checks,
                                    const Built& built, const Variant& variant, ProgramRun& run,
                                    const std::function<void()>& after_public = {});

/// Rounded to hundredths, in which points are given, since nobody could check a sum of shares such
/// as 1/3.
double in_hundredths(double number);

/// The sum of the points.
double total(const std::vector<CheckResult>& results);

/// What a solution of the instructor's own, right or wrong, reached.
struct SolutionTrial {
  double points = 0;
  std::vector<std::string> losses;  ///< a line for each check that does not give all its points,
                                    ///< and for each of single_numbers whose task is never asked
};

/// How to run the instructor's own programs. They need not be kept from anything, but where several
/// run at a time, the sandbox keeps the end of one from ending all.
inline Isolation isolation_of(std::size_t n_jobs) {
  return n_jobs > 1 ? Isolation::sandbox : Isolation::none;
}

/// Compiles a solution in a scratch folder and tries the checks on it.
SolutionTrial try_solution(const Assignment& assignment, const std::filesystem::path& toolkit,
                           const Files& solution, const Checks& checks, const Variant& variant,
                           Isolation isolation);

/// Tries the checks on a solution that is compiled already.
SolutionTrial try_solution(const Assignment& assignment, const Built& built, const Checks& checks,
                           const Variant& variant, Isolation isolation);

/// Whether two sums of points are the same to the hundredth that points are given in.
bool are_same_points(double a, double b);

}  // namespace course
