// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "literate/figures/figure.hpp"

namespace assignment {

/// The triangle of eq. (4), and overlapping triangles with their sum.
literate::Figure setting();

/// How many digits of the slope are wrong when eq. (3)'s three terms are added as they stand,
/// against the distance from the load.
literate::Figure lost_digits();

}  // namespace assignment
