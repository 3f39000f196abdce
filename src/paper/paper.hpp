// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "literate/document/document.hpp"
#include "literate/excerpts/excerpt.hpp"
#include "literate/main/paper.hpp"
#include "parameters/case.hpp"

namespace paper {

/// Computes all that the report says about a case and registers it with the document: values,
/// tables, figures, and the checks that must hold. Tables and values about what the paper prints
/// exist only if the case has printed data (flag `printed`).
void compute(literate::Document& document, const parameters::Case& from_file);

/// What the report is computed from and by: the case, the commit, the compiler and the libraries.
void describe_provenance(literate::Document& document, const parameters::Case& from_file,
                         const literate::Paper& paper);

/// How much of the mechanics below `source`/src the excerpts show, and of which files nothing.
void register_coverage(literate::Document& document, const std::filesystem::path& source,
                       const std::vector<literate::Excerpt>& excerpts);

}  // namespace paper
