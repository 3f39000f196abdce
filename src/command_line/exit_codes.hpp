// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "system/error.hpp"

namespace command_line {

using sys::ExitCode;

/// What all messages of this program begin with: the name that it was started by, unless a
/// different one was set.
std::string program_name();
void set_program_name(const std::string& name);

/// Prints a message as a line on standard error, and returns `exit_code`.
ExitCode complain(const std::string& message, ExitCode exit_code);

/// Runs a command; turns what it throws into one message on standard error and its exit code.
ExitCode run_guarded(const std::function<ExitCode()>& command);

}  // namespace command_line
