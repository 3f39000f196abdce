// SPDX-License-Identifier: GPL-3.0-or-later
// The subcommands of `halfspace-course`, and the options that several of them have.
#pragma once

#include <optional>
#include <string>

#include "command_line/options.hpp"
#include "course/assignment/assignment.hpp"
#include "course/assignment/variant.hpp"
#include "course/marking/roster.hpp"

namespace CLI {
class App;
}

namespace course_app {
using namespace command_line;  // the commands are made of its functions

/// Each adds a subcommand with its flags to the program; parsing the command line runs the chosen
/// one, which stores its answer in `exit_code`.
void add_handout_command(CLI::App& program, ExitCode& exit_code);
void add_solution_command(CLI::App& program, ExitCode& exit_code);
void add_prove_command(CLI::App& program, ExitCode& exit_code);
void add_check_variants_command(CLI::App& program, ExitCode& exit_code);
void add_toolkit_command(CLI::App& program, ExitCode& exit_code);
void add_grade_command(CLI::App& program, ExitCode& exit_code);
void add_list_command(CLI::App& program, ExitCode& exit_code);
void add_student_command(CLI::App& program, ExitCode& exit_code);
void add_class_command(CLI::App& program, ExitCode& exit_code);
void add_collect_command(CLI::App& program, ExitCode& exit_code);
void add_likeness_command(CLI::App& program, ExitCode& exit_code);
void add_marking_command(CLI::App& program, ExitCode& exit_code);
void add_results_command(CLI::App& program, ExitCode& exit_code);
void add_sheet_command(CLI::App& program, ExitCode& exit_code);

/// Adds compute, typeset and check: what makes the assignment's sheet.
void add_sheet_stages(CLI::App& program, ExitCode& exit_code);

/// Options that several subcommands have, and what adds them to one.
struct CourseOptions {
  std::string assignment = "report/assignment";
  std::string source = ".";
  std::string student, seed, seed_file;
  std::string submissions, roster, toolkit, output;
};

void add_assignment(CLI::App& command, CourseOptions& options);
void add_source(CLI::App& command, CourseOptions& options);
void add_student(CLI::App& command, CourseOptions& options);
void add_seed(CLI::App& command, CourseOptions& options);
void add_submissions(CLI::App& command, CourseOptions& options);
void add_roster(CLI::App& command, CourseOptions& options);
void add_toolkit(CLI::App& command, CourseOptions& options);
/// Adds the folder that a command replaces as a whole.
void add_output(CLI::App& command, CourseOptions& options);

/// A whole number from 1 to `most`; throws sys::InputError for another one.
long number_of(const NumberOption& option, long otherwise, long most);

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
