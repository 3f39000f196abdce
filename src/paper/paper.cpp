// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/paper.hpp"

#include "paper/sections.hpp"

namespace paper {

void compute(literate::Document& document, const parameters::Case& from_file) {
  document.flag("printed", from_file.printed.has_value());
  describe_provenance(document, from_file);
  compute_formulation(document, from_file);
  compute_quadrature(document, from_file);
  compute_results(document, from_file);
  compute_block(document, from_file);
  compute_error_analysis(document, from_file);
  compute_cylinders(document, from_file);
  if (from_file.printed) compute_contact_m(document, from_file);
  compute_elements(document, from_file);
  compute_methods(document, from_file);
  compute_profiles(document, from_file);
  compute_regions(document, from_file);
  compute_friction(document, from_file);
  compute_stresses(document, from_file);
}

}  // namespace paper
