// SPDX-License-Identifier: GPL-3.0-or-later
// Exercise 2: the slope by numerical integration. This header is part of the handout.
#pragma once

#include "assignment/given/student_types.hpp"

namespace exercise {

/// ∂u_z/∂x under any load from eq. (2), by numerical integration,
///
///   ∂u_z/∂x = −[2(1−ν²)/(πE)] PV∫ p(s)/(x−s) ds over −a ≤ s ≤ a,
///
/// a Cauchy principal value where x lies under the load. `value` must be good to 10⁻⁷ of the
/// greatest slope, and the truth must lie within `abs_error` of it, also where GSL's own estimate
/// is too small. An error of zero, or of more than 10⁻⁶ of the greatest slope, does not count, and
/// neither does one number above 10⁻⁹ of it for all places of a load.
Estimate normal_gradient_by_quadrature(const Material& material, const Load& load, double x);

}  // namespace exercise
