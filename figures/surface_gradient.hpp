// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "literate/figures/plot.hpp"

namespace figures {

/// ∂u_z/∂x of three loads with the same resultant, in units of K/a against x/a; NaN for a gap.
struct SurfaceGradient {
  std::vector<double> x, concentrated, uniform, triangular;
};

/// Shows which element makes a finite slope.
void draw_surface_gradient(literate::Plot& plot, const SurfaceGradient& data);

}  // namespace figures
