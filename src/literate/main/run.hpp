// SPDX-License-Identifier: GPL-3.0-or-later
// What the programs of papers and literate-results have in common.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "literate/document/document.hpp"
#include "system/error.hpp"

namespace literate {

/// Runs a program. An exception becomes a line on standard error and the exit code 2 for bad input,
/// or 3 for anything else.
int run(const std::function<sys::ExitCode()>& program);

/// Writes the folder, and a line on standard error for each check that failed and each claim with a
/// different verdict than expected; these give the exit code 1.
sys::ExitCode write_and_report(const Document& document, const std::filesystem::path& folder,
                               const std::string& case_name);

}  // namespace literate
