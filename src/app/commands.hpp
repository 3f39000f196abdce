// SPDX-License-Identifier: GPL-3.0-or-later
// The commands of the program.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "app/flags.hpp"

namespace app {

/// Adds a command, whose flags are the members of Options. Its help begins with the description,
/// which also appears in the list of commands, and ends with `more`, as it is.
template <class Options>
void add_command(CLI::App& program, const std::string& name, const std::string& description,
                 const std::string& more, void (*run)(const Options&)) {
  CLI::App* command = program.add_subcommand(name, wrapped(description))->group("Commands");
  command->footer(more);
  const std::shared_ptr<Options> options(new Options{*command});
  command->callback([run, options] { run(*options); });
}

void add_displacement_command(CLI::App& program);
void add_contact_command(CLI::App& program);
void add_point_contact_command(CLI::App& program);
void add_stress_command(CLI::App& program);
void add_block_command(CLI::App& program);

}  // namespace app
