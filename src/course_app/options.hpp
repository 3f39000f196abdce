// SPDX-License-Identifier: GPL-3.0-or-later
// Options that several subcommands of `halfspace-course` have.
#pragma once

#include <optional>
#include <string>

#include "course/assignment/assignment.hpp"
#include "course/assignment/variant.hpp"
#include "course/marking/roster.hpp"

namespace CLI {
class App;
}

namespace course_app {

struct CourseOptions {
  std::string assignment = "report/assignment";
  std::string source = ".";
  std::string student, seed, seed_file;
};

void add_assignment(CLI::App& command, CourseOptions& options);
void add_source(CLI::App& command, CourseOptions& options);
void add_student(CLI::App& command, CourseOptions& options);
void add_seed(CLI::App& command, CourseOptions& options);

/// Reads the assignment and makes sure that each of its checks has code.
course::Assignment read_assignment(const CourseOptions& options);

/// The class in a file; none if no file is given.
std::optional<course::Roster> roster_of(const std::string& file);

/// The seed, given as such or in a file, without the line end; empty if neither is given. Throws
/// sys::InputError if both are given or the file holds no seed.
std::string seed_of(const CourseOptions& options);

/// The student's numbers, or the nominal ones if no student is given. Throws sys::InputError if
/// only one of student and seed is given.
course::Variant variant_of(const CourseOptions& options, const course::Assignment& assignment);

}  // namespace course_app
