// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "paper/prelude.hpp"
#include "paper/printed_data.hpp"
#include "parameters/case.hpp"

namespace paper {

/// All that a section computes from: the case and, if it is the paper's own, what the paper prints.
struct Case : parameters::Case {
  std::optional<PrintedData> printed_data;
};

/// A section that computes something. Its prose is report/sections/NAME.tex, with - for _, and its
/// function, compute_NAME, is in NAME_section.cpp. It leaves out what the case does not have.
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
void compute_block(Document& document, const Case& from);
void compute_tangential(Document& document, const Case& from);
void compute_cylinders(Document& document, const Case& from);
void compute_contact_m(Document& document, const Case& from);
void compute_elements(Document& document, const Case& from);
void compute_spheres(Document& document, const Case& from);

/// Computes all that the report says about a case and registers it with the document.
///
/// What concerns the paper's own numbers is registered only for the paper's case (flag `printed`),
/// what concerns a block or spheres only if the case has them (flags `block`, `point-contact`).
/// Returns what the log should say about the case: empty, or why the sections about the print are
/// left out. Throws config::Error for a case of which the report cannot be made.
std::string compute(Document& document, const parameters::Case& from_file);

}  // namespace paper
