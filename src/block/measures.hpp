// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "block/solution.hpp"

namespace block {

/// One line of Appendix 2: its printed name, and its value.
struct Measure {
  std::string name;
  double value;
};

/// A disc of the block, to be left out.
struct Disc {
  double x;
  double z;
  double radius;
};

/// Where and how densely measures are taken.
struct MeasureOptions {
  std::vector<double> surface_points = {};  ///< x of measure1, measure2, …
  std::vector<Disc> singular_discs = {};    ///< left out of max_stress_prin_regular
  int plotting_grid = 10;  ///< intervals an element edge is sampled at, as in the original
};

/// The measures of Appendix 2 under their printed names, in the axes of that appendix: x along the
/// surface, y up (−z here), z out of the plane (y here).
///
/// measure1 … are −u_z at the given points of the top. max_disp_mag is |u|; max_disp_*,
/// max_stress_* and max_prin_mag are the values of largest magnitude with their sign, the leftmost
/// if several agree to 1e-6; max_stress_prin and min_stress_prin the algebraically largest and
/// least principal stress, σ_zz included; strain_energy is ½∫σ·ε per unit thickness;
/// resultant_load_x, _y the load. Rotations and out-of-plane shears are zero in a plane model of
/// solid elements.
///
/// Maxima are taken over the plotting grid of every element; the grid's own error is of second
/// order in its spacing. Where a pressure jumps (edge_fraction > 0) the stresses beside the jump
/// have no limit as the mesh is refined: polynomials overshoot a jump by a tenth of it, however
/// small the element (Gibbs), and max_stress_prin is made of that; beside a corner between a
/// clamped and a free side stresses grow without bound. So the greatest principal stress is given
/// once more, as max_stress_prin_regular, over the points outside the singular_discs, if there are
/// any. Throws InvalidQuantity for a point off the block and plotting_grid < 1.
std::vector<Measure> measures(const Solution& solution, const MeasureOptions& options);

}  // namespace block
