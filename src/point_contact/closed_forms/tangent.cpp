// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/closed_forms/tangent.hpp"

#include <cmath>

namespace point_contact {

double excess_over_arctangent(double w) {
  // Beyond 0.6 the subtraction loses less than four bits; below, 40 terms of the series
  // w³/3 − w⁵/5 + … reach rounding.
  constexpr double near = 0.6;
  if (w > near) return w - std::atan(w);
  constexpr int n_terms = 40;
  double sum = 0;
  for (int k = n_terms; k >= 1; --k) sum = 1.0 / (2 * k + 1) - w * w * sum;
  return w * w * w * sum;
}

}  // namespace point_contact
