// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "course/assignment/assignment.hpp"
#include "course/assignment/check.hpp"
#include "course/release/handout.hpp"

namespace course {

/// Which variants are tried, and with what.
struct VariantCheckInput {
  const Assignment& assignment;
  const Project& project;
  Checks visible, hidden;
  std::filesystem::path toolkit;
  std::function<bool(const Variant&)> is_valid;
  std::string seed;
  std::vector<std::string> students;
  std::size_t n_jobs = 1;
  std::filesystem::path handouts = {};  ///< holds STUDENT and STUDENT.zip of each; may be empty
  std::vector<std::filesystem::path> secret_files = {};  ///< as those of a proof
};

/// The names student-1, student-2, … for a class that is not known yet.
std::vector<std::string> invented_students(std::size_t count);

/// Compiles the instructor's solution once and tries it on the variant of each student. Returns a
/// line for each on which it does not score all points, and for each two that are alike.
///
/// Where there are handouts, what is each student's own is proved too: that the handout is the
/// project with this variant and a sheet, holds no secret and none of the values that are expected
/// of this student, and is the same as its zip. The rest of the proof is the same for all of a
/// class: course/release/proof.hpp.
std::vector<std::string> faults_of_variants(const VariantCheckInput& input);

}  // namespace course
