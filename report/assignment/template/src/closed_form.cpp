// SPDX-License-Identifier: GPL-3.0-or-later
// Exercise 1: the slope under a triangular load in closed form, eq. (3).
#include <cmath>
#include <limits>
#include <numbers>

#include "assignment/given/student_functions.hpp"

namespace exercise {
namespace {

// BEGIN SOLUTION
// The limit of t ln|t| at t = 0 is 0.
double t_ln_t(double t) {
  return t == 0 ? 0 : t * std::log(std::abs(t));
}

// (ξ+1) ln|ξ+1| + (ξ−1) ln|ξ−1| − 2ξ ln|ξ|. For |ξ| ≥ 2, subtract ln|ξ| from each logarithm: these
// parts cancel, and the remaining logarithms are small.
double slope_bracket(double xi) {
  if (std::abs(xi) < 2) return t_ln_t(xi + 1) + t_ln_t(xi - 1) - 2 * t_ln_t(xi);
  return xi * std::log1p(-1 / (xi * xi)) + 2 * std::atanh(1 / xi);
}
// END SOLUTION

}  // namespace

double normal_gradient(const Material& material, const TriangularLoad& load, double x) {
  // BEGIN SOLUTION
  // STUB: return std::numeric_limits<double>::quiet_NaN();
  const double nu = material.poisson;
  const double greatest =
      2 * (1 - nu * nu) * load.peak_pressure / (std::numbers::pi * material.young);
  return -greatest * slope_bracket(x / load.half_width);
  // END SOLUTION
}

}  // namespace exercise
