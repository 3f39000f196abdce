// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "literate/figures/plot.hpp"

namespace figures {

/// Fig. 4 of the paper: u_z by eq. (3), and the finite-element columns of Fig. 5 where there are
/// any. Lengths in `unit`.
struct DisplacementComparison {
  std::vector<double> x, analytical;                  ///< a smooth curve
  std::vector<double> printed_x, printed_analytical;  ///< the paper's analytical column
  std::vector<double> fea_z, fea_magnitude;           ///< the paper's finite-element columns
  double half_width;
  std::string unit;
};

void draw_displacement_comparison(literate::Plot& plot, const DisplacementComparison& data);

}  // namespace figures
