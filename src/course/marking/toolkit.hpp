// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "course/assignment/assignment.hpp"

namespace course {

/// The folder with everything that is compiled once for all submissions of an assignment: the
/// files that students do not write, a stub for each file that they do, and a precompiled header.
/// No solution is in it: the programs on which students' own tests are tried lie beside it.
struct Toolkit {
  std::filesystem::path folder;

  std::filesystem::path project() const { return folder / "project"; }
  std::filesystem::path stub_of(const std::string& file) const;
  /// The report as students get it: the program of its numbers, scripts of its drawings. It is not
  /// there if the assignment has no report.
  std::filesystem::path report() const { return project() / "report"; }
  /// Is compiled in advance, into a file beside it.
  std::filesystem::path header() const { return folder / "precompiled.hpp"; }
  /// The folder with the programs for the tests of an exercise, `right` and wrong/ID for each wrong
  /// solution of it. No job can read it.
  std::filesystem::path programs_of(const std::string& exercise) const;
  /// Holds the main() with which students' own tests are run.
  std::filesystem::path replay_object() const { return folder / "objects/provided/replay.cpp.o"; }
  /// Holds main().
  std::filesystem::path main_object() const { return folder / "objects/provided/main.cpp.o"; }
  /// Holds all other given objects.
  std::filesystem::path archive() const { return folder / "given.a"; }
};

/// Finds a toolkit that make_toolkit (course/release/make_toolkit.hpp) wrote. Throws OutputError if
/// the folder holds none, or that of another assignment.
Toolkit open_toolkit(const Assignment& assignment, const std::filesystem::path& folder);

/// The compiler's flags, with which the precompiled header was made as well. `project` is the
/// project's folder as the compiler sees it.
std::vector<std::string> compile_flags(const std::string& project);

/// The linker's arguments that follow the objects.
std::vector<std::string> link_flags();

}  // namespace course
