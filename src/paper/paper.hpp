// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "literate/document/document.hpp"
#include "literate/excerpts/excerpt.hpp"
#include "literate/main/paper.hpp"
#include "paper/prelude.hpp"
#include "paper/printed_data.hpp"
#include "parameters/case.hpp"

namespace paper {

/// The sources, a checkout, and the excerpts of them that the report may show.
struct Listings {
  std::filesystem::path source;
  std::vector<literate::Excerpt> excerpts;
};

/// All that a section computes from: the case, and what else the report knows.
struct Case : parameters::Case {
  std::optional<PrintedData> printed_data;  ///< what the paper prints
  std::optional<Listings> listings;
  literate::Paper paper;
};

/// A section that computes something. Its name is that of its prose, with _ for -, and of its file,
/// NAME_section.cpp, which defines compute_NAME. It leaves out what the case does not have.
struct Section {
  std::string name;
  void (*compute)(Document& document, const Case& from);
};

/// All of them in the order of the report, which numbers the claims.
const std::vector<Section>& sections();

void compute_formulation(Document& document, const Case& from);
void compute_quadrature(Document& document, const Case& from);
void compute_results(Document& document, const Case& from);
void compute_error_analysis(Document& document, const Case& from);
void compute_finite_block(Document& document, const Case& from);
void compute_tangential(Document& document, const Case& from);
void compute_cylinders(Document& document, const Case& from);
void compute_octave(Document& document, const Case& from);
void compute_contact_m(Document& document, const Case& from);
void compute_elements(Document& document, const Case& from);
void compute_spheres(Document& document, const Case& from);
void compute_provenance(Document& document, const Case& from);

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
