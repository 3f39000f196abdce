// SPDX-License-Identifier: GPL-3.0-or-later
// What the subcommands of `halfspace-course` have in common.
#pragma once

#include <string>

#include "course/assignment/assignment.hpp"
#include "course/assignment/variant.hpp"

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

/// Reads the assignment and asks whether each of its checks has code, before any work.
course::Assignment read_assignment(const CourseOptions& options);

/// The seed, or that in the seed's file without the line end; empty without either. Throws
/// sys::InputError if both are given or the file holds none.
std::string seed_of(const CourseOptions& options);

/// The student's numbers, or the nominal ones where there is no student. Throws sys::InputError
/// where there is no seed for the student, or no student for the seed.
course::Variant variant_of(const CourseOptions& options, const course::Assignment& assignment);

}  // namespace course_app
