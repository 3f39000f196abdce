// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/hertz.hpp"

#include <gsl/gsl_sf_ellint.h>

#include <cmath>
#include <numbers>

#include "system/require.hpp"

namespace point_contact {
namespace {

double carlson_rf(double x, double y, double z) {
  return gsl_sf_ellint_RF(x, y, z, GSL_PREC_DOUBLE);
}
double carlson_rd(double x, double y, double z) {
  return gsl_sf_ellint_RD(x, y, z, GSL_PREC_DOUBLE);
}

// κ_x/κ_y = R_D(0, b², a²)/R_D(0, a², b²) of an ellipse with b/a = exp(log_ratio); it increases.
double curvature_ratio(double log_ratio) {
  const double square = std::exp(2 * log_ratio);
  return carlson_rd(0, square, 1) / carlson_rd(0, 1, square);
}

// ln(b/a) to 60 bits by bisection. The interval contains all allowed ratios, because b/a is nearer
// to 1 than κ_x/κ_y is.
double log_axis_ratio(double wanted) {
  double low = -std::abs(std::log(wanted)) - 1;
  double high = -low;
  for (int bit = 0; bit < 60; ++bit) {
    const double middle = (low + high) / 2;
    (curvature_ratio(middle) < wanted ? low : high) = middle;
  }
  return (low + high) / 2;
}

double require_ratio(double curvature_x, double curvature_y) {
  sys::require_positive("curvature_x", curvature_x);
  sys::require_positive("curvature_y", curvature_y);
  const double ratio = curvature_x / curvature_y;
  if (!(ratio >= 1e-8 && ratio <= 1e8)) {
    throw sys::InvalidQuantity("curvature_x/curvature_y", ratio, "from 1e-8 to 1e8");
  }
  return ratio;
}

}  // namespace

Hertz::Hertz(double contact_modulus, double relative_curvature, double load)
    : relative_curvature_(sys::require_positive("relative_curvature", relative_curvature)),
      radius_(std::cbrt(
          3 * sys::require_positive("load", load) /
          (4 * sys::require_positive("contact_modulus", contact_modulus) * relative_curvature))),
      peak_pressure_(3 * load / (2 * std::numbers::pi * radius_ * radius_)) {}

double Hertz::pressure(double r) const {
  // a − r is exact near the edge; 1 − (r/a)² would not be.
  const double from_edge = radius_ - std::abs(r);
  if (from_edge <= 0) return 0;
  return peak_pressure_ / radius_ * std::sqrt(from_edge * (radius_ + std::abs(r)));
}

HertzElliptic::HertzElliptic(double contact_modulus, double curvature_x, double curvature_y,
                             double load) {
  sys::require_positive("contact_modulus", contact_modulus);
  sys::require_positive("load", load);
  const double ratio = std::exp(log_axis_ratio(require_ratio(curvature_x, curvature_y)));
  // κ_x = (2p₀ab/(3E*)) R_D(0, b², a²) = (P/(πE*)) R_D(0, ratio², 1)/a³
  a_ = std::cbrt(load * carlson_rd(0, ratio * ratio, 1) /
                 (std::numbers::pi * contact_modulus * curvature_x));
  b_ = ratio * a_;
  peak_pressure_ = 3 * load / (2 * std::numbers::pi * a_ * b_);
  approach_ = peak_pressure_ * b_ / contact_modulus * carlson_rf(0, 1, ratio * ratio);
}

double HertzElliptic::pressure(const Vector2& at) const {
  const double xi = at.x() / a_;
  const double eta = at.y() / b_;
  const double square = (1 - xi) * (1 + xi) - eta * eta;
  return square > 0 ? peak_pressure_ * std::sqrt(square) : 0;
}

}  // namespace point_contact
