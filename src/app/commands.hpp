// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "command_line/exit_codes.hpp"

namespace CLI {
class App;
}

namespace app {
using namespace command_line;  // the commands are made of its functions

/// Each adds a subcommand with its flags to the program; parsing the command line runs the chosen
/// one, which stores its answer in `exit_code`.
void add_displacement_command(CLI::App& program, ExitCode& exit_code);
void add_block_command(CLI::App& program, ExitCode& exit_code);
void add_contact_command(CLI::App& program, ExitCode& exit_code);
void add_stress_command(CLI::App& program, ExitCode& exit_code);

/// Adds compute, draw, typeset and check: what makes the report.
void add_report_stages(CLI::App& program, ExitCode& exit_code);

}  // namespace app
