// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "course/assignment/assignment.hpp"

namespace course {

/// Runs `make` and `make check` in a copy of a handout, as a student does first, and compiles
/// `n_jobs` files at a time. Returns a line for each error and warning of the compiler, and for
/// each check but the hidden ones whose id `make check` does not print. Throws sys::ToolError if
/// make is not installed.
std::vector<std::string> faults_of_student_build(const Assignment& assignment,
                                                 const std::filesystem::path& handout,
                                                 std::size_t n_jobs);

}  // namespace course
