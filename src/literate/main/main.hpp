// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>

#include "literate/document/document.hpp"

namespace literate {

/// Computes what a paper says from the file of its case, and registers it with the document.
using Compute = std::function<void(Document& document, const std::filesystem::path& case_file)>;

/// The main() of a paper's program:
///
///     int main(int argc, char** argv) { return literate::main(argc, argv, compute); }
///
/// `PROGRAM compute CASE FOLDER` computes and writes the folder (literate/document/folder.hpp).
/// Returns the exit code for the shell: 0; 1 if a check failed or a claim has a different verdict
/// than expected, each with a line on standard error (the folder is complete all the same); 2 for
/// bad input and 3 for a computation that stopped, and then nothing is written. On a terminal a
/// line shows the seconds, and the counts of Document::progress.
int main(int argc, char** argv, const Compute& compute);

}  // namespace literate
