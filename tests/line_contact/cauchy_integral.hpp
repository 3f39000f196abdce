// SPDX-License-Identifier: GPL-3.0-or-later
// Eq. (2)'s integral of a traction with root singularities at its edges, as the closed forms are
// tried by it.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "numerics/kernel_integrals.hpp"
#include "numerics/piecewise.hpp"

/// PV∫ p(s)/(x−s) ds over −a < s < a, for a traction p with kinks at ±`kink` (none: 0).
///
/// Over s = a sin θ, x = a sin θ₀: inside, the kernel is 1/(θ₀−θ) times a smooth function. ds is
/// taken from the rounded s, so that p ds has its digits beside the edges too.
inline double cauchy_integral(const std::function<double(double)>& traction, double a, double x,
                              double kink = 0) {
  constexpr double right = std::numbers::pi / 2;
  const double inner = std::nextafter(a, 0);
  const double pole = std::abs(x) < a ? std::asin(x / a) : 0;
  const auto per_angle = [=, &traction](double theta) {
    const double s = std::clamp(a * std::sin(theta), -inner, inner);
    const double density = traction(s) * std::sqrt((a - s) * (a + s));
    if (std::abs(x) > a) return density / (x - s);
    const double half = (pole - theta) / 2;
    const double sinc = half == 0 ? 1 : std::sin(half) / half;
    return density / (a * sinc * std::cos((pole + theta) / 2));
  };
  std::vector<numerics::Piece> pieces{{-right, right, per_angle}};
  if (kink != 0) {
    const double angle = std::asin(kink / a);
    pieces = {{-right, -angle, per_angle}, {-angle, angle, per_angle}, {angle, right, per_angle}};
  }
  const numerics::KernelIntegrals integrals{numerics::PiecewiseFunction(pieces)};
  return std::abs(x) < a ? integrals.cauchy(pole).value : integrals.total().value;
}
