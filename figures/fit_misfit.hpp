// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "literate/figures/plot.hpp"

namespace figures {

/// The largest relative misfit of the printed displacements over the edge fraction of the load,
/// with the best peak for each; one curve a kind of side.
struct FitMisfit {
  std::vector<double> edge_fraction, clamped, roller, free;
};

void draw_fit_misfit(literate::Plot& plot, const FitMisfit& data);

}  // namespace figures
