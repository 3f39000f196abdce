// SPDX-License-Identifier: GPL-3.0-or-later
// The subcommands of the program `literate`.
#pragma once

#include "system/error.hpp"

namespace CLI {
class App;
}

namespace literate {

/// Adds `literate new DIR`, which writes a paper that builds at once.
void add_new_command(CLI::App& program, sys::ExitCode& exit_code);

/// Adds `literate excerpts`, by which the build writes down what a program is compiled from.
void add_excerpts_command(CLI::App& program, sys::ExitCode& exit_code);

/// Adds `literate changes`, which compares two states of a paper.
void add_changes_command(CLI::App& program, sys::ExitCode& exit_code);

}  // namespace literate
