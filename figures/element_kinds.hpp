// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "literate/figures/plot.hpp"

namespace figures {

/// What the same load does to the surface as a force, a uniform pressure and a triangle; against
/// x/c, all dimensionless. NaN where infinite.
struct ElementKinds {
  std::vector<double> x;
  std::vector<double> point_displacement, uniform_displacement, triangular_displacement;
  std::vector<double> point_gradient, uniform_gradient, triangular_gradient;
};

/// Displacements on the left, gradients on the right.
void draw_element_kinds(literate::Plot& plot, const ElementKinds& data);

}  // namespace figures
