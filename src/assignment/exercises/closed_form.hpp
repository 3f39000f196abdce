// SPDX-License-Identifier: GPL-3.0-or-later
// Exercise 1: the slope in closed form. This header is part of the handout.
#pragma once

#include "assignment/given/student_types.hpp"

namespace exercise {

/// The triangular pressure of eq. (4), p(x) = (p₀/a)(a − |x|) for |x| ≤ a and 0 elsewhere.
struct TriangularLoad {
  double peak_pressure;  ///< p₀, Pa
  double half_width;     ///< a, m
};

/// ∂u_z/∂x of the surface under a triangular load, the derivative of eq. (3), with ξ = x/a:
///
///   ∂u_z/∂x = −[2(1−ν²)p₀/(πE)] [(ξ+1) ln|ξ+1| + (ξ−1) ln|ξ−1| − 2ξ ln|ξ|].
///
/// For any x, including the kinks 0 and ±a, where t ln|t| has the limit 0. Far from the load the
/// three terms are large and their sum is small. It must have eight correct digits even at 10⁸ a.
double normal_gradient(const Material& material, const TriangularLoad& load, double x);

}  // namespace exercise
