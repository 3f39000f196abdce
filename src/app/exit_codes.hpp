// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace app {

/// What the program answers to the shell.
enum class ExitCode : int {
  success = 0,
  claim_failed = 1,  ///< a check or a computation did not hold
  bad_input = 2,     ///< a flag, a case file, a document or an output folder
  tool_failed = 3,   ///< gnuplot or LaTeX is missing or failed
};

/// Runs a command; turns what it throws into one message on standard error and its exit code.
ExitCode run_guarded(const std::function<ExitCode()>& command);

}  // namespace app
