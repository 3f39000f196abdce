// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "block/discretization.hpp"
#include "block/solution.hpp"

namespace block {

/// One line of Appendix 2: its printed name and its value.
struct Measure {
  std::string name;
  double value;
};

/// The measures of Appendix 2 under their printed names, in the axes of that appendix: x along the
/// surface, y up (−z here), z out of the plane (y here).
///
/// max_disp_mag is |u|; max_disp_*, max_stress_* and max_prin_mag are the values of largest
/// magnitude with their sign, the leftmost if several agree to 1e-6; max_stress_prin and
/// min_stress_prin are the algebraically largest and least principal stresses, including σ_zz;
/// strain_energy is ½∫σ·ε per unit thickness, resultant_load_y the load. measure1, measure2, … are
/// −u_z at the given points of the top.
///
/// Stresses exclude the discs `left_out`. A maximum starts from the best of eleven by eleven points
/// per element and of points on the discs' circles; the search then climbs to within a thousandth
/// of their spacing. Throws InvalidQuantity for a point outside the block.
std::vector<Measure> measures(const Solution& solution, const std::vector<Disc>& left_out,
                              const std::vector<double>& surface_points = {});

}  // namespace block
