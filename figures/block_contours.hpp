// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "literate/figures/plot.hpp"

namespace figures {

/// A grid of points of the deformed block, row by row from the top, n_along_x points a row.
struct ContourWindow {
  std::vector<double> x, y, u_z;
  int n_along_x;
};

/// The whole block and a close-up of the loaded region, as in Fig. 3 of the paper; lengths in
/// `unit`.
struct BlockContours {
  ContourWindow whole, close_up;
  double half_width;  ///< of the load
  double largest;     ///< u_z, where the colours end
  std::string unit;
};

/// Draws filled contours of u_z on the deformed block, ten bands from light to dark.
void draw_block_contours(literate::Plot& plot, const BlockContours& data);

}  // namespace figures
