// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "course/marking/grading.hpp"

namespace course {

/// What something of the instructor's own scores.
struct Score {
  double points = 0;
  std::vector<std::string> losses;  ///< a line for each check that does not give all its points
};

/// How to run what is the instructor's own. It need not be kept from anything, but where several
/// run at a time, the sandbox keeps the end of one from being the end of all.
inline Isolation isolation_of(std::size_t n_jobs) {
  return n_jobs > 1 ? Isolation::sandbox : Isolation::none;
}

/// Compiles a submission in a scratch folder and tries the checks on it.
Score score_of(const Assignment& assignment, const std::filesystem::path& toolkit,
               const Files& submission, const Checks& checks, const Variant& variant,
               Isolation isolation);

/// Tries the checks on what is compiled already.
Score score_of(const Assignment& assignment, const Built& built, const Checks& checks,
               const Variant& variant, Isolation isolation);

/// Whether two sums of points are the same to the hundredth that points are given in.
bool are_same_points(double a, double b);

}  // namespace course
