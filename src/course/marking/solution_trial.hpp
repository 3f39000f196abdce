// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "course/marking/try_checks.hpp"

namespace course {

/// What a solution of the instructor's own, right or wrong, reached.
struct SolutionTrial {
  double points = 0;
  std::vector<std::string> losses;  ///< a line for each check that does not give all its points
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
