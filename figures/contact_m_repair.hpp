// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "literate/figures/plot.hpp"

namespace figures {

/// The pressures of Contact.m from its printed state to its mended one, over p₀ and against x/a of
/// Hertz under the right load.
struct ContactMRepair {
  struct Panel {
    std::string title;                ///< LaTeX
    std::vector<double> x, pressure;  ///< at the nodes, linear between them
    double own_half_width, own_p0;    ///< of the Hertz that the program compares with
  };
  std::vector<Panel> panels;  ///< drawn in rows of three
};

/// One panel a state: the program's pressure on the shaded pressure of Hertz, and dashed the Hertz
/// of its own lines. A pressure that leaves the frame has its greatest value written beside it.
void draw_contact_m_repair(literate::Plot& plot, const ContactMRepair& data);

}  // namespace figures
