// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact/hertz.hpp"
#include "contact/solution.hpp"
#include "parameters/case.hpp"

namespace paper {

/// What a solution of elements says between and beneath its nodes, held against Hertz and McEwen.
struct ElementQuality {
  double slope;  ///< largest error of ∂(u_z1 + u_z2)/∂x, over a/R, its value at the edge
  double shear;  ///< largest error of τ₁ half a spacing below the surface, over p₀
};

/// Over |x| ≤ 0.9 a, at eighths between the nodes, where no element is infinite.
ElementQuality quality_of(const parameters::ContactCase& c, const contact::Hertz& hertz,
                          const contact::Solution& solution);

}  // namespace paper
