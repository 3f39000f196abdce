// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "literate/figures/plot.hpp"

namespace figures {

/// The shear traction under one tangential load; q over μp₀, against x/a.
struct SlipCurve {
  double share;                      ///< Q/(μP)
  double stick;                      ///< half-width of the strip that sticks, over a
  std::vector<double> x, shear;      ///< the closed form
  std::vector<double> node_x, node;  ///< the elements
};

/// Three loads, the least first, and q = μp: the bodies slide.
struct PartialSlip {
  std::array<SlipCurve, 3> curves;
  std::vector<double> sliding_x, sliding;
};

/// Lines for the closed form, points for the elements, bars below for the strips that stick.
void draw_partial_slip(literate::Plot& plot, const PartialSlip& data);

}  // namespace figures
