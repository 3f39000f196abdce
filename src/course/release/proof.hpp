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

/// What is proved of a handout, and with what.
struct ProofInput {
  const Assignment& assignment;
  const Project& project;
  Checks visible, hidden;
  Variant variant;                                  ///< that the handout is of
  std::filesystem::path handout;                    ///< the folder that students get
  std::filesystem::path zip;                        ///< the same, packed; may be empty
  std::filesystem::path toolkit;                    ///< of `course toolkit`
  std::vector<std::filesystem::path> secret_files;  ///< sources that no line of may be given away
  std::filesystem::path source;                     ///< the checkout that provided files are from
  std::size_t n_jobs = 1;
};

/// A claim about a handout and why it does not hold, a line each; it does if there is none.
struct ProvedClaim {
  std::string says;
  std::vector<std::string> faults;
};

/// Proves that a handout may be given to students:
/// - it is of the variant;
/// - it compiles as a student does it, with `make` and without a warning, and `make check` names
///   every public check;
/// - as it is, it scores the assignment's floor; the instructor's solution scores all points; each
///   wrong solution, with the nominal numbers, scores what the list says;
/// - it holds no secret and provides nothing of the reference (course/release/leaks.hpp), and its
/// zip no
///   other files.
///
/// Tells of each claim when it is tried; returns whether all hold. More than one job at a time
/// takes bubblewrap. Throws ToolError, OutputError and CaseError as its parts do.
bool prove(const ProofInput& input, const std::function<void(const ProvedClaim&)>& tell);

}  // namespace course
