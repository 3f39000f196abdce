// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "literate/figures/plot.hpp"

namespace figures {

/// The pressure between two cylinders, over p₀ and against x/a of Hertz.
struct CylinderPressure {
  std::vector<double> x, pressure;     ///< at the nodes
  std::vector<double> hertz_x, hertz;  ///< a smooth curve
  std::vector<double> difference;      ///< pressure − Hertz at the nodes, over p₀
};

/// Above the pressure, below its difference from Hertz.
void draw_cylinder_pressure(literate::Plot& plot, const CylinderPressure& data);

}  // namespace figures
