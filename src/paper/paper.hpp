// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "paper/conventions.hpp"
#include "paper/printed_data.hpp"
#include "parameters/case.hpp"
#include "point_contact/hertz.hpp"
#include "point_contact/solution.hpp"

namespace paper {

/// The input of a section: the case and, for the paper's own case, the printed data.
struct Case : parameters::Case {
  std::optional<PrintedData> printed_data;
};

/// A section with computed results. Its prose is report/sections/NAME.tex, with - for _, and its
/// function, compute_NAME, is in NAME_section.cpp. It skips the parts that the case lacks.
struct Section {
  std::string name;
  void (*compute)(Document& document, const Case& from);
};

/// All sections in the order of the report, which numbers the claims.
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

/// Spheres with the radii and materials of the case's cylinders, by Hertz and by pyramids on a
/// square lattice with no node at the centre.
struct Spheres {
  point_contact::Hertz hertz;
  point_contact::Solution solution;
};
Spheres solve_spheres(const ContactCase& c, const PointContactCase& p);

/// The magnitudes of the relative errors against Hertz.
struct SphereErrors {
  double peak, radius, approach;
  double square;  ///< (c/a)²
};
SphereErrors errors_of(const Spheres& spheres);

/// Computes all results of the report for a case and registers them with the document.
///
/// Results about the paper's own numbers are registered only for the paper's case (flag `printed`),
/// those about a block or spheres only if the case has them (flags `block`, `point-contact`).
/// Returns a line for the log: empty, or the reason for omitting the sections about the print.
/// Throws config::Error for a case that the report cannot handle.
std::string compute(Document& document, const parameters::Case& from_file);

}  // namespace paper
