// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "course/assignment.hpp"
#include "course/check.hpp"
#include "course/handout.hpp"

namespace course {

/// Which variants are tried, and with what.
struct VariantCheckInput {
  const Assignment& assignment;
  const Project& project;
  Checks visible, hidden;
  std::filesystem::path toolkit;
  std::function<bool(const Variant&)> is_valid;
  std::string seed;
  std::size_t count = 1;  ///< of students, who are called student-1, student-2, …
  std::size_t n_jobs = 1;
};

/// Compiles the instructor's solution once and tries it on the variant of each student. Returns a
/// line for each on which it does not score all points, and for each two that are alike.
std::vector<std::string> faults_of_variants(const VariantCheckInput& input);

}  // namespace course
