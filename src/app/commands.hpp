// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exit_codes.hpp"

namespace CLI {
class App;
}

namespace app {

/// Each adds a subcommand with its flags to the program; parsing the command line runs the chosen
/// one, which stores its answer in `exit_code`.
void add_displacement_command(CLI::App& program, ExitCode& exit_code);
void add_block_command(CLI::App& program, ExitCode& exit_code);
void add_contact_command(CLI::App& program, ExitCode& exit_code);
void add_stress_command(CLI::App& program, ExitCode& exit_code);
void add_report_command(CLI::App& program, ExitCode& exit_code);
void add_typeset_command(CLI::App& program, ExitCode& exit_code);
void add_describe_command(CLI::App& program, ExitCode& exit_code);
void add_check_report_command(CLI::App& program, ExitCode& exit_code);
void add_course_command(CLI::App& program, ExitCode& exit_code);

}  // namespace app
