// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "literate/figures/plot.hpp"

namespace figures {

/// The element boundaries of the block, and the load's half-width; lengths in `unit`.
struct BlockMesh {
  std::vector<double> x_lines, z_lines;
  double half_width;
  std::string unit;
};

/// Draws the whole mesh, and what of it lies about the load.
void draw_block_mesh(literate::Plot& plot, const BlockMesh& data);

}  // namespace figures
