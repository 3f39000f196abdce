// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "block/discretization.hpp"
#include "block/solution.hpp"

namespace block {

/// One line of Appendix 2: its printed name, and its value.
struct Measure {
  std::string name;
  double value;
};

/// The measures of Appendix 2 under their printed names, in the axes of that appendix: x along the
/// surface, y up (−z here), z out of the plane (y here).
///
/// max_disp_mag is |u|; max_disp_*, max_stress_* and max_prin_mag are the values of largest
/// magnitude with their sign, the leftmost if several agree to 1e-6; max_stress_prin and
/// min_stress_prin the algebraically largest and least principal stress, σ_zz included;
/// strain_energy is ½∫σ·ε per unit thickness, resultant_load_y the load. measure1 … are −u_z at the
/// given points of the top.
///
/// Stresses are those outside the discs `left_out`. A maximum is the best of eleven by eleven
/// points of every element, from which the search climbs until it stands still to a thousandth of
/// their spacing, and of points on the discs' circles. Throws InvalidQuantity for a point off the
/// block.
std::vector<Measure> measures(const Solution& solution, const std::vector<Disc>& left_out,
                              const std::vector<double>& surface_points = {});

}  // namespace block
