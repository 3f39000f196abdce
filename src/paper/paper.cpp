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
  compute_error_analysis(document, from_file);
  compute_block(document, from_file);
  compute_cylinders(document, from_file);
}

}  // namespace paper
