// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "literate/figures/plot.hpp"

namespace figures {

/// The pressure between wavy cylinders at growing loads, over p₀ and against x/a of smooth ones.
struct SeveralRegions {
  struct Panel {
    std::string title;                ///< the load, LaTeX
    std::vector<double> x, pressure;  ///< at the nodes
    std::vector<double> smooth;       ///< between smooth cylinders under the same load
  };
  std::vector<Panel> panels;
};

/// One above the other, the least load on top.
void draw_several_regions(literate::Plot& plot, const SeveralRegions& data);

}  // namespace figures
