// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "literate/figures/plot.hpp"

namespace figures {

/// Relative changes of measures of the block that are left to refinement, by the elements' order.
struct BlockConvergence {
  std::vector<double> order;
  std::vector<double> displacement, energy, von_mises;
};

void draw_block_convergence(literate::Plot& plot, const BlockConvergence& data);

}  // namespace figures
