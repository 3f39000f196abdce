// SPDX-License-Identifier: GPL-3.0-or-later
// The commands of the program.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "command_line/exit_codes.hpp"

namespace CLI {
class App;
}

namespace app {

using command_line::ExitCode;

/// The help of a command besides its flags.
struct CommandText {
  std::string name;
  std::string description;  ///< its first sentence also appears in the list of commands
  std::string examples;     ///< as printed: what each does, then the command line
};

/// Adds a command: `set_up` adds its flags and returns the function that runs it.
void add_command(CLI::App& program, const CommandText& text, ExitCode& exit_code,
                 const std::function<std::function<ExitCode()>(CLI::App&)>& set_up);

/// The same for a command whose flags are the members of Options.
template <class Options>
void add_command(CLI::App& program, const CommandText& text, ExitCode& exit_code,
                 ExitCode (*run)(const Options&)) {
  add_command(program, text, exit_code, [run](CLI::App& command) {
    const std::shared_ptr<Options> options(new Options{command});
    return [run, options] { return run(*options); };
  });
}

/// Each adds a command, which stores its exit code in `exit_code`.
void add_displacement_command(CLI::App& program, ExitCode& exit_code);
void add_contact_command(CLI::App& program, ExitCode& exit_code);
void add_point_contact_command(CLI::App& program, ExitCode& exit_code);
void add_stress_command(CLI::App& program, ExitCode& exit_code);
void add_block_command(CLI::App& program, ExitCode& exit_code);

}  // namespace app
