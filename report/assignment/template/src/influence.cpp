// SPDX-License-Identifier: GPL-3.0-or-later
// Exercise 4: the influence coefficients of overlapping triangles.
#include <cmath>
#include <limits>
#include <numbers>

#include "assignment/given/student_functions.hpp"

namespace exercise {
namespace {

// BEGIN SOLUTION
// (1 + t)² ln(1 + t) for t ≥ −1, with its limit 0 at t = −1.
double square_ln(double t) {
  return t == -1 ? 0 : (1 + t) * (1 + t) * std::log1p(t);
}

// T(k) by eq. (3). For k ≥ 2, subtract ln k from each logarithm, so that no digits are lost.
double unit_coefficient(double k) {
  k = std::abs(k);
  if (k == 0) return -1.5;
  if (k < 2) {
    const double below = k - 1 == 0 ? 0 : (k - 1) * (k - 1) * std::log(std::abs(k - 1));
    return (square_ln(k) + below - 2 * k * k * std::log(k)) / 2 - 1.5;
  }
  const double rest = (k * k + 1) * std::log1p(-1 / (k * k)) + 4 * k * std::atanh(1 / k);
  return std::log(k) + rest / 2 - 1.5;
}
// END SOLUTION

}  // namespace

double influence_coefficient(double contact_modulus, double spacing, double datum, int k) {
  // BEGIN SOLUTION
  // STUB: return std::numeric_limits<double>::quiet_NaN();
  const double rise = unit_coefficient(k) - unit_coefficient(datum / spacing);
  return -2 * spacing / (std::numbers::pi * contact_modulus) * rise;
  // END SOLUTION
}

}  // namespace exercise
