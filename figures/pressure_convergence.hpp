// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "literate/figures/plot.hpp"

namespace figures {

/// Errors of the pressure over p₀ against the number of elements over the half-width.
struct PressureConvergence {
  std::vector<double> elements;  ///< a/c of each even grid
  std::vector<double> triangular_inside, triangular_largest;
  std::vector<double> uniform_inside, uniform_largest;
  std::vector<double> graded_elements, graded_largest;
};

/// One point a grid, and lines of slope −½ and −2.
void draw_pressure_convergence(literate::Plot& plot, const PressureConvergence& data);

}  // namespace figures
