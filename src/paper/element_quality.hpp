// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "line_contact/solution.hpp"
#include "paper/prelude.hpp"

namespace paper {

/// What a solution of elements says between and beneath its nodes, held against Hertz and McEwen.
///
/// The slope of uniform elements is infinite at their ends, so that a largest error would belong to
/// the points at which it is sought. Means over |x| ≤ 0.9 a are finite for all elements but forces.
struct ElementQuality {
  Estimate slope;  ///< mean |error| of ∂(u_z1 + u_z2)/∂x, over a/R, its value at the edge
  Estimate shear;  ///< mean |error| of τ₁ half a spacing below the surface, over p₀
};

/// By the midpoint rule on x ≥ 0, of which the other side is the image, extrapolated; wrong by the
/// difference from half as many points. The number of nodes is odd.
ElementQuality quality_of(const ContactCase& c, const Hertz& hertz,
                          const line_contact::Solution& solution);

}  // namespace paper
