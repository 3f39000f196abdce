// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "literate/figures/plot.hpp"

namespace figures {

/// Contacts of several profiles under one load, over p₀ and against x/a of the cylinders, x ≥ 0.
struct ProfilePressures {
  struct Panel {
    std::string title;                   ///< LaTeX
    std::vector<double> x, pressure;     ///< at the nodes, or some of them
    std::vector<double> exact_x, exact;  ///< the closed form; NaN where it is infinite
    std::vector<double> hertz;           ///< of the cylinders, at exact_x
  };
  std::vector<Panel> panels;  ///< four
};

/// Two by two: elements as circles, closed form solid, cylinders dash-dotted.
void draw_profile_pressures(literate::Plot& plot, const ProfilePressures& data);

}  // namespace figures
