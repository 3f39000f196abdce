// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/paper.hpp"

#include <utility>

#include "system/parallel.hpp"

namespace paper {

void compute(Document& document, const parameters::Case& from_file,
             const std::optional<Listings>& listings, const literate::Paper& paper) {
  require_reportable(from_file);
  const Case from{from_file, read_printed(from_file), listings, paper};
  document.flag("printed", from.printed_data.has_value());
  document.flag("point-contact", from.point_contact.has_value());
  document.flag("block", from.block.has_value());
  document.flag("block.fitted", from.block && from.printed_data);

  std::vector<Document> documents(sections().size());
  // The last sections take the longest, and begin first.
  sys::for_each_parallel(documents.size(), 0, [&](std::size_t n_begun) {
    const std::size_t i = documents.size() - 1 - n_begun;
    sections()[i].compute(documents[i], from);
  });
  for (Document& part : documents) document.append(std::move(part));
}

const std::vector<Section>& sections() {
  static const std::vector<Section> list = {
      {"formulation", &compute_formulation},   {"quadrature", &compute_quadrature},
      {"results", &compute_results},           {"error_analysis", &compute_error_analysis},
      {"finite_block", &compute_finite_block}, {"tangential", &compute_tangential},
      {"cylinders", &compute_cylinders},       {"octave", &compute_octave},
      {"contact_m", &compute_contact_m},       {"elements", &compute_elements},
      {"spheres", &compute_spheres},           {"provenance", &compute_provenance}};
  return list;
}

}  // namespace paper
