// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "literate/figures/plot.hpp"

namespace figures {

/// Fig. 1 of the paper: the surfaces of two bodies, body 1 below, pressed together by δ: as they
/// would overlap undeformed, and deformed. Heights are positive upwards, x over the half-width.
struct ContactGeometry {
  std::vector<double> x;
  std::vector<double> before1, before2;  ///< undeformed
  std::vector<double> after1, after2;    ///< deformed
  double apex;                           ///< height of body 1's undeformed apex, δ/2
  double x_of_u, before_at_u;            ///< where u_z1 and u_z2 are shown; before1 there
  double x_of_h, before_at_h;            ///< where the gap h = h1 + h2 is shown; before1 there
  double height;                         ///< of the figure's halves
};

void draw_contact_geometry(literate::Plot& plot, const ContactGeometry& data);

}  // namespace figures
