// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/sections.hpp"

namespace paper {

const std::vector<Section>& sections() {
  static const std::vector<Section> list = {
      {"provenance", &compute_provenance},     {"formulation", &compute_formulation},
      {"quadrature", &compute_quadrature},     {"results", &compute_results},
      {"finite_block", &compute_finite_block}, {"error_analysis", &compute_error_analysis},
      {"cylinders", &compute_cylinders},       {"octave", &compute_octave},
      {"contact_m", &compute_contact_m},       {"elements", &compute_elements},
      {"methods", &compute_methods},           {"profiles", &compute_profiles},
      {"regions", &compute_regions},           {"friction", &compute_friction},
      {"stresses", &compute_stresses},         {"spheres", &compute_spheres}};
  return list;
}

}  // namespace paper
