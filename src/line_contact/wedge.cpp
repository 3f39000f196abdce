// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/wedge.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "system/require.hpp"

namespace line_contact {
namespace {

// ξ arccos(1/ξ) − arcosh ξ by s = √(1 − 1/ξ²), in which it is arcsin(s)/√(1−s²) − artanh s:
//   Σ [(2k)!!/(2k+1)!! − 1/(2k+1)] s^{2k+1}, k = 1, 2, …, every term positive.
double series_from_edge(double s) {
  double sum = 0;
  double double_factorials = 1;
  double power = s;
  for (int k = 1; power > std::numeric_limits<double>::epsilon() * sum; ++k) {
    double_factorials *= 2.0 * k / (2 * k + 1);
    power *= s * s;
    sum += (double_factorials - 1.0 / (2 * k + 1)) * power;
  }
  return sum;
}

// Above this s the difference keeps all digits but one; below it the series needs at most 25 terms.
constexpr double near_edge_squared = 0.2;

}  // namespace

Wedge::Wedge(double contact_modulus, double slope, double line_load)
    : slope_(sys::require_positive("slope", slope)),
      line_load_(sys::require_positive("load", line_load)),
      half_width_(line_load / (sys::require_positive("contact_modulus", contact_modulus) * slope)) {
}

double Wedge::pressure(double x) const {
  const double a = half_width_;
  x = std::abs(x);
  if (x >= a) return 0;
  // arcosh(a/x) is written as arsinh(√(a²−x²)/x), which loses no digits near the edge
  return line_load_ / (std::numbers::pi * a) * std::asinh(std::sqrt((a - x) * (a + x)) / x);
}

double Wedge::gap(double x) const {
  const double a = half_width_;
  x = std::abs(x);
  if (x <= a) return 0;
  const double root = std::sqrt((x - a) * (x + a));
  const double scale = slope_ * a * 2 / std::numbers::pi;
  const double s = root / x;
  if (s * s < near_edge_squared) return scale * series_from_edge(s);
  return scale * (x / a * std::atan2(root, a) - std::asinh(root / a));
}

}  // namespace line_contact
