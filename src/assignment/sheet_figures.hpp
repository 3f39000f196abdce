// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "literate/figures/plot.hpp"

namespace assignment {

/// Draws the triangle of eq. (4) on the left, and overlapping triangles with their sum on the
/// right.
void draw_setting(literate::Plot& plot);

/// Draws how many digits of the slope are wrong when eq. (3)'s three terms are added as they
/// stand, against the distance from the load.
void draw_lost_digits(literate::Plot& plot);

}  // namespace assignment
