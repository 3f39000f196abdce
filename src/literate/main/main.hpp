// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "literate/document/document.hpp"
#include "system/error.hpp"

namespace literate {

/// Reads the case file, computes, and registers the results with the document.
using Compute = std::function<void(Document& document, const std::filesystem::path& case_file)>;

/// The main() of a paper's program:
///
///     int main(int argc, char** argv) { return literate::main(argc, argv, compute); }
///
/// `PROGRAM compute CASE FOLDER` computes and writes the folder (literate/document/folder.hpp).
/// Returns the exit code: 0; 1 if a check failed or a claim has an unexpected verdict, each with a
/// line on standard error (the folder is complete); 2 for bad input; 3 if the computation failed.
/// After 2 and 3 nothing is written. A terminal shows the elapsed seconds and the counts of
/// Document::progress.
int main(int argc, char** argv, const Compute& compute);

/// Runs a program, of a paper or literate-results, and returns its exit code. An exception prints
/// one line on standard error and gives 2 for bad input, 3 for anything else. The argument --help
/// prints the usage; arguments that are not complete print it on standard error and give 2.
int run(int argc, char** argv, bool are_complete, const std::string& usage,
        const std::function<sys::ExitCode()>& program);

/// Writes the folder and prints, on standard error, each failed check and each claim with an
/// unexpected verdict. If there is one, the exit code is 1.
sys::ExitCode write_and_report(const Document& document, const std::filesystem::path& folder,
                               const std::string& case_name);

}  // namespace literate
