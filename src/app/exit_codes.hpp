// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace app {

/// What the program answers to the shell.
enum class ExitCode : int {
  success = 0,
  claim_failed = 1,  ///< a check, a claim, a lint or a computation did not hold
  bad_input = 2,     ///< a flag, a case file, a document or an output folder
  tool_failed = 3,   ///< gnuplot or LaTeX is missing or failed
};

/// Runs a command; turns what it throws into one message on standard error and its exit code.
ExitCode run_guarded(const std::function<ExitCode()>& command);

/// Prints each fault of a document as a line on standard error: claim_failed if there is any.
ExitCode answer_faults(const std::vector<std::string>& faults);

}  // namespace app
