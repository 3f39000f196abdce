// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "system/error.hpp"

namespace app {

using sys::ExitCode;

/// Runs a command; turns what it throws into one message on standard error and its exit code.
ExitCode run_guarded(const std::function<ExitCode()>& command);

/// Prints each fault of a document as a line on standard error: failed if there is any.
ExitCode answer_faults(const std::vector<std::string>& faults);

}  // namespace app
