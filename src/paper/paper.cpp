// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/paper.hpp"

#include "paper/sections.hpp"
#include "system/parallel.hpp"

namespace paper {
namespace {

using Section = void (*)(literate::Document&, const parameters::Case&);

// In the order of the report, which numbers the claims.
std::vector<Section> sections_for(const parameters::Case& from_file) {
  std::vector<Section> sections{compute_formulation, compute_quadrature,
                                compute_results,     compute_block,       compute_error_analysis,
                                compute_cylinders};
  if (from_file.printed) sections.push_back(compute_contact_m);
  sections.insert(sections.end(), {compute_elements, compute_methods, compute_profiles,
                                   compute_regions, compute_friction, compute_stresses});
  return sections;
}

}  // namespace

void compute(literate::Document& document, const parameters::Case& from_file) {
  document.flag("printed", from_file.printed.has_value());
  const std::vector<Section> sections = sections_for(from_file);
  std::vector<literate::Document> parts(sections.size());
  sys::for_each_parallel(sections.size(), 0,
                         [&](std::size_t i) { sections[i](parts[i], from_file); });
  for (literate::Document& part : parts) document.append(std::move(part));
}

}  // namespace paper
