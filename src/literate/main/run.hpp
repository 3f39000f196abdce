// SPDX-License-Identifier: GPL-3.0-or-later
// Shared by the programs of papers and literate-results.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "literate/document/document.hpp"
#include "system/error.hpp"

namespace literate {

/// Runs a program and returns its exit code. An exception prints one line on standard error and
/// gives 2 for bad input, 3 for anything else.
int run(const std::function<sys::ExitCode()>& program);

/// Writes the folder and prints, on standard error, each failed check and each claim with an
/// unexpected verdict. If there is one, the exit code is 1.
sys::ExitCode write_and_report(const Document& document, const std::filesystem::path& folder,
                               const std::string& case_name);

}  // namespace literate
