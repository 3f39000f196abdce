// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "system/error.hpp"

namespace command_line {

using sys::ExitCode;

/// The name at the beginning of each message: the one with which the program was started, unless
/// set_program_name() has changed it.
std::string program_name();
void set_program_name(const std::string& name);

/// Prints a message on standard error and returns `exit_code`.
ExitCode complain(const std::string& message, ExitCode exit_code);

/// Runs a command. Converts an exception to a message on standard error and an exit code.
ExitCode run_guarded(const std::function<ExitCode()>& command);

}  // namespace command_line
