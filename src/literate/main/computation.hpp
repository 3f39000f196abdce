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

}  // namespace literate
