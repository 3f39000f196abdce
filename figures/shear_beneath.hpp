// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "literate/figures/plot.hpp"

namespace figures {

/// Where a contour gets its number, or the greatest value its cross.
struct FieldLabel {
  double x, z, value;
};

/// τ₁/p₀ beneath one contact, at every pair of the figure's x and z.
struct ShearField {
  double friction;          ///< μ
  std::vector<double> tau;  ///< row by row, one z a row
  std::vector<FieldLabel> labels;
  FieldLabel greatest;
};

/// The greatest shear in the plane beneath two contacts; lengths over the half-width a.
struct ShearBeneath {
  std::vector<double> x, z;  ///< rising
  std::vector<double> levels;
  ShearField still, sliding;
  std::vector<double> depth, closed;     ///< on the axis of the first, McEwen
  std::vector<double> node_depth, node;  ///< from the elements
};

/// Contours with their numbers, and the profile along the axis.
void draw_shear_beneath(literate::Plot& plot, const ShearBeneath& data);

}  // namespace figures
