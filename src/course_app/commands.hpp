// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "command_line/exit_codes.hpp"

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

}  // namespace course_app
