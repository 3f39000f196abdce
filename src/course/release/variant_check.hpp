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

/// The variants to be tried, and what is needed for it.
struct VariantCheckInput {
  const Assignment& assignment;
  const Project& project;
  Checks visible, hidden;
  std::filesystem::path toolkit;
  std::function<bool(const Variant&)> is_valid;
  std::string seed;
  std::vector<std::string> students;
  std::size_t n_jobs = 1;
  std::filesystem::path handouts = {};  ///< holds STUDENT and STUDENT.zip for each; may be empty
  std::vector<std::filesystem::path> secret_files = {};  ///< as in ProofInput
};

/// The names student-1, student-2, …, for a class that is not known yet.
std::vector<std::string> invented_students(std::size_t count);

/// Compiles the instructor's solution once and tries it on the variant of each student. Returns
/// a line for each loss of points, and for each two students with the same variant.
///
/// If there are handouts, it also proves what differs between them: each is the project with
/// this student's variant and a sheet, holds no secret and none of the values that are expected of
/// this student, and is the same as its zip. The rest of the proof (course/release/proof.hpp) is
/// the same for the whole class.
std::vector<std::string> faults_of_variants(const VariantCheckInput& input);

}  // namespace course
