// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "command_line/options.hpp"

namespace app {
using namespace command_line;  // the commands are made of its parts

/// Adds a subcommand whose flags are an Options, and which runs with them.
template <class Options>
void add_command(CLI::App& program, const std::string& name, const std::string& description,
                 ExitCode& exit_code, ExitCode (*run)(const Options&)) {
  command_line::add_command(program, name, description, exit_code, [run](CLI::App& command) {
    return [run, options = std::make_shared<Options>(command)] { return run(*options); };
  });
}

/// Each adds a subcommand with its flags to the program; parsing the command line runs the chosen
/// one, which stores its answer in `exit_code`.
void add_displacement_command(CLI::App& program, ExitCode& exit_code);
void add_block_command(CLI::App& program, ExitCode& exit_code);
void add_contact_command(CLI::App& program, ExitCode& exit_code);
void add_point_contact_command(CLI::App& program, ExitCode& exit_code);
void add_stress_command(CLI::App& program, ExitCode& exit_code);

/// All subcommands, in the order in which the help lists them.
inline const std::vector<AddCommand> all_commands{add_displacement_command, add_block_command,
                                                  add_contact_command, add_point_contact_command,
                                                  add_stress_command};

}  // namespace app
