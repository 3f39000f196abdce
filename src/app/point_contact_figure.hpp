// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/point_contact_output.hpp"
#include "literate/figures/figure.hpp"

namespace app {

/// What there is to draw of a point contact: the pressure about the contact on a rectangular grid
/// of at most 200 × 200 points, and along both axes through the middle of its pressure, with
/// Hertz's beside it for curved bodies.
literate::Figure point_contact_figure(const PointContactInput& input,
                                      const SolvedPointContact& solved,
                                      const config::UnitSystem& units);

}  // namespace app
