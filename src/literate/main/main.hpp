// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "literate/document/document.hpp"
#include "literate/excerpts/excerpt.hpp"
#include "literate/main/paper.hpp"

namespace literate {

/// What a paper is computed from.
struct Inputs {
  std::filesystem::path case_file;  ///< the parameters
  std::filesystem::path source;     ///< the paper's checkout
  std::vector<Excerpt> excerpts;    ///< of its sources
  std::string paper = {};  ///< its NAME in literate_add_paper, of a program that has several
};

/// Computes what a paper says and registers it with the document.
using Compute = std::function<void(Document& document, const Inputs& inputs)>;

/// Runs the stage of a paper that the command line names, and returns the exit code for the shell:
/// 0 done, 1 a check, a claim or a computation failed, 2 bad input, 3 gnuplot or LaTeX failed.
///
/// `compute` writes values, tables, excerpts and the figures' data, after it has made sure that the
/// excerpts are what the program was compiled from. `draw` runs gnuplot on the figures that
/// changed. `typeset` looks up all names of the prose, makes the PDF and its manifest. `check`
/// looks for unknown and unused names and for typed numbers. `describe` writes for archives what a
/// folder of results holds. Every error is one line on standard error that begins with the paper's
/// name.
int main(int argc, char** argv, const Paper& paper, const Compute& compute);

}  // namespace literate
