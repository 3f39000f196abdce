// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "literate/document/document.hpp"
#include "literate/excerpts/excerpt.hpp"

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

/// Computes. On a terminal a line tells every ten seconds for how long, and what was registered
/// last.
///
/// An exception that says nothing of where it comes from becomes a sys::ComputationError with its
/// type and what was registered last. A signal that ends the program, as after a wrong pointer, is
/// told with the same. If LITERATE_TIMEOUT, a number of seconds, is set and they are over, the
/// program ends with 1 and a line: no computation can be ended from outside in another way.
void compute_guarded(Document& document, const Inputs& inputs, const Compute& compute);

}  // namespace literate
