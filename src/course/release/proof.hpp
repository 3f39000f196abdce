// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "course/assignment/assignment.hpp"
#include "course/assignment/check.hpp"
#include "course/assignment/variant.hpp"
#include "course/release/handout.hpp"

namespace course {

/// The handout to be proved, and what is needed for it.
struct ProofInput {
  const Assignment& assignment;
  const Project& project;
  Checks visible, hidden;
  Variant variant;                                  ///< the variant of the handout
  std::filesystem::path handout;                    ///< the folder that students get
  std::filesystem::path zip;                        ///< the same, packed; may be empty
  std::filesystem::path toolkit;                    ///< the folder of the toolkit
  std::vector<std::filesystem::path> secret_files;  ///< sources of which no line may be given away
  std::filesystem::path source;                     ///< the checkout from which provided files come
  std::size_t n_jobs = 1;
  /// Whether the points that the wrong solutions score are written to the list, for somebody to
  /// review, instead of being compared with it.
  bool updates_points = false;
};

/// A claim about a handout, and a line for each reason why it does not hold; without any it holds.
struct ProvedClaim {
  std::string says;
  std::vector<std::string> faults;
};

/// Proves that a handout may be given to students:
/// - it is of the variant;
/// - it compiles with `make`, as students do it, without a warning, and `make check` names every
///   public check;
/// - as it is, it scores the assignment's floor; the instructor's solution scores all points; each
///   wrong solution, with the nominal numbers, scores what the list says;
/// - it holds no secret and provides nothing of the reference (course/release/leaks.hpp), and its
///   zip holds the same files.
///
/// Passes each claim to `tell` when it has been tried, and returns whether all hold. More than
/// one job at a time needs bubblewrap. Throws ToolError, OutputError and config::Error as its parts
/// do.
bool prove(const ProofInput& input, const std::function<void(const ProvedClaim&)>& tell);

/// Runs `make` and `make check` in a copy of a handout, as a student does first, and compiles
/// `n_jobs` files at a time. Returns a line for each error and warning of the compiler, and for
/// each check but the hidden ones whose id `make check` does not print. Throws sys::ToolError if
/// make is not installed.
std::vector<std::string> faults_of_student_build(const Assignment& assignment,
                                                 const std::filesystem::path& handout,
                                                 std::size_t n_jobs);

}  // namespace course
