// SPDX-License-Identifier: GPL-3.0-or-later
// Exercise 2: the slope by numerical integration. This header is part of the handout.
#pragma once

#include "assignment/given/student_types.hpp"

namespace exercise {

/// ∂u_z/∂x under any load from eq. (2), by numerical integration,
///
///   ∂u_z/∂x = −[2(1−ν²)/(πE)] PV∫ p(s)/(x−s) ds over −a ≤ s ≤ a,
///
/// a Cauchy principal value if x lies under the load. `value` must be accurate to 10⁻⁷ of the
/// greatest slope, and the true slope must lie within `abs_error` of it, even where GSL's own
/// estimate is too small. An error bound must be greater than zero and at most 10⁻⁶ of the greatest
/// slope. The same bound at all places of a load does not count if it exceeds 10⁻⁹ of that slope.
Estimate normal_gradient_by_quadrature(const Material& material, const Load& load, double x);

}  // namespace exercise
