// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "literate/figures/plot.hpp"

namespace figures {

/// u_z of the half-space, of the block under the stated and the fitted load, and as printed;
/// lengths in `unit`.
struct LikeWithLike {
  std::vector<double> x, half_space, block_stated, block_fitted;
  std::vector<double> printed_x, printed;
  std::string unit;
};

void draw_like_with_like(literate::Plot& plot, const LikeWithLike& data);

}  // namespace figures
