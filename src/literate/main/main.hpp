// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "literate/main/computation.hpp"
#include "literate/main/paper.hpp"

namespace literate {

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
