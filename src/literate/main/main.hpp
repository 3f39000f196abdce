// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>

#include "literate/document/document.hpp"

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

}  // namespace literate
