// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "elasticity/piecewise_linear_load.hpp"
#include "line_contact/graded_contact.hpp"
#include "system/require.hpp"

namespace line_contact {

using Eigen::Index;
using Eigen::VectorXd;
using elasticity::element_potential;
using std::numbers::pi;

double GradedSolution::pressure_at(double at) const {
  if (!(at > edges.left && at < edges.right)) return 0;
  const Index end = std::upper_bound(x.begin() + 1, x.end() - 1, at) - x.begin();
  const double share = (at - x[end - 1]) / (x[end] - x[end - 1]);
  return (1 - share) * pressure[end - 1] + share * pressure[end] +
         4 * share * (1 - share) * bulge[end - 1];
}

double GradedSolution::peak_pressure() const {
  double peak = pressure.maxCoeff();
  for (Index e = 0; e < bulge.size(); ++e) {
    // The parabola of the element has its top where ½ + rise/(8 bulge) of the element's length is
    // passed.
    const double rise = pressure[e + 1] - pressure[e];
    if (!(std::abs(rise) < 4 * bulge[e])) continue;
    const double mean = (pressure[e] + pressure[e + 1]) / 2;
    peak = std::max(peak, mean + bulge[e] + rise * rise / (16 * bulge[e]));
  }
  return peak;
}

double GradedSolution::line_load() const {
  const Index n = bulge.size();
  const VectorXd length = x.tail(n) - x.head(n);
  return length.dot(pressure.head(n) + pressure.tail(n)) / 2 + 2 * length.dot(bulge) / 3;
}

double GradedSolution::approach(double datum) const {
  sys::require_finite("datum", datum);
  const double a = half_width();
  double sum = 0;
  for (Index e = 0; e < bulge.size(); ++e) {
    const auto v =
        element_potential((x[e] - datum) / a, (x[e + 1] - datum) / a, (x[e + 1] - x[e]) / a);
    sum += v.begin * pressure[e] + v.end * pressure[e + 1] + v.middle * bulge[e];
  }
  return approach_at_half_width + 2 * a / (pi * contact_modulus) * sum;
}

}  // namespace line_contact
