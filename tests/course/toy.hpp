// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "course/assignment/assignment.hpp"
#include "course/release/handout.hpp"
#include "toy/hidden/hidden_checks.hpp"
#include "toy/template/provided/toy_checks.hpp"

/// The assignment of tests/course/toy.
namespace toy {

inline const std::filesystem::path source = HALFSPACE_SOURCE_DIR;
inline const std::filesystem::path folder = source / "tests/course/toy";

inline course::Assignment assignment() {
  return course::read_assignment(folder);
}

inline course::Project project() {
  return course::read_project(assignment(), source);
}

}  // namespace toy
