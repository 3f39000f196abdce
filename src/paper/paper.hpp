// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "literate/document/document.hpp"
#include "literate/main/paper.hpp"
#include "paper/sections.hpp"
#include "parameters/case.hpp"

namespace paper {

/// Throws config::Error, with file, line, column and key, for a case that the commands can compute
/// but the report cannot be made of: one that is too large for it, whose title or file name LaTeX
/// cannot print, or of which what the report says would not be true.
void require_reportable(const parameters::Case& c);

/// Computes all that the report says about a case and registers it with the document: values,
/// tables, figures, claims, and the checks that must hold. Sections are computed at the same time.
///
/// What concerns the paper's own numbers exists only if the case has printed data (flag `printed`),
/// what concerns the finite block only if the case has one (flag `block`; `block.fitted` with
/// both), and how much the listings show only with `listings`. `paper` tells the
/// version and compiler that the report states. Throws config::Error for a case that is not
/// reportable, for printed data that are not right, and what the computations throw.
void compute(literate::Document& document, const parameters::Case& from_file,
             const std::optional<Listings>& listings = std::nullopt,
             const literate::Paper& paper = {});

}  // namespace paper
