// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/bodies/curvatures.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include "system/require.hpp"

namespace point_contact {

RelativeCurvatures relative_curvatures(PrincipalCurvatures body1, PrincipalCurvatures body2,
                                       double angle) {
  sys::require_finite("angle", angle);
  const double sum = body1.first + body1.second + body2.first + body2.second;
  if (!(std::isfinite(sum) && sum > 0)) {
    throw sys::InvalidQuantity("sum of the curvatures", sum,
                               "greater than 0, or the bodies do not touch at a point");
  }
  // h = Σ/4 r² + ¼ Re[(Δ₁ + Δ₂ e^{2iα}) e^{−2iθ}] r², least where the bracket's phase is opposite
  const std::complex<double> difference =
      body1.first - body1.second + (body2.first - body2.second) * std::polar(1.0, 2 * angle);
  const double smaller = (sum - std::abs(difference)) / 2;
  const double rounding = 1e-15 * (std::abs(body1.first) + std::abs(body1.second) +
                                   std::abs(body2.first) + std::abs(body2.second));
  if (!(smaller > rounding)) {
    throw sys::InvalidQuantity("least relative curvature", smaller,
                               "greater than 0, or the bodies do not touch at a point alone");
  }
  const double phase = difference == 0.0 ? 0 : std::arg(-difference) / 2;
  return {smaller, (sum + std::abs(difference)) / 2, phase};
}

}  // namespace point_contact
