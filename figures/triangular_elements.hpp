// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "literate/figures/plot.hpp"

namespace figures {

/// Fig. 2 of the paper: pressures p_j at nodes a distance c apart, over p₀ and against x/c.
struct TriangularElements {
  std::vector<double> x, pressure;
};

/// Draws each node's triangle and their sum, the piecewise linear pressure.
void draw_triangular_elements(literate::Plot& plot, const TriangularElements& data);

}  // namespace figures
