// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "literate/excerpts/excerpt.hpp"

namespace literate {

/// How much of a folder's code a document shows.
struct ExcerptCoverage {
  int n_lines = 0;                ///< of code, without blank lines, comments and directives
  int n_shown = 0;                ///< those of them that are within excerpts
  std::vector<std::string> rest;  ///< the files of which nothing is shown, sorted
};

/// Counts the *.cpp files below `folder` of a source root. Throws sys::OutputError if it cannot be
/// read.
ExcerptCoverage coverage_of(const std::filesystem::path& source_root, const std::string& folder,
                            const std::vector<Excerpt>& excerpts);

}  // namespace literate
