// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/uniform_load.hpp"

#include <algorithm>
#include <cmath>

#include "system/require.hpp"

namespace elasticity {
namespace {

// [(ξ+1) ln|ξ+1| − (ξ−1) ln|ξ−1|] for ξ = x/a ≥ 0, outside as 2 ln ξ + [(1+η) ln(1+η) − (1−η)
// ln(1−η)]/η with η = 1/ξ, whose two terms have one sign.
double edge_logarithms(double x, double a) {
  const auto t_log = [](double t) { return t == 0 ? 0 : t * std::log(t); };
  if (x <= a) return t_log((a + x) / a) + t_log((a - x) / a);
  const double eta = a / x;
  const double below = eta < 0.5 ? (1 - eta) * std::log1p(-eta) : t_log((x - a) / x);
  return 2 * std::log(x / a) + ((1 + eta) * std::log1p(eta) - below) / eta;
}

}  // namespace

UniformLoad::UniformLoad(double pressure, double half_width)
    : pressure_(sys::require_positive("pressure", pressure)),
      half_width_(sys::require_positive("half_width", half_width)) {}

UniformLoad::operator Load() const {
  Load load;
  load.normal = numerics::PiecewiseFunction(
      {{-half_width_, half_width_, [p = pressure_](double) { return p; }}});
  return load;
}

double normal_gradient(const Material& material, const UniformLoad& load, double x) {
  const double a = load.half_width();
  const double distance = std::abs(sys::require_finite("x", x));
  if (distance == a) {
    throw sys::InvalidQuantity("x", x, "off the edge of the load, where the gradient is infinite");
  }
  // ln|(x+a)/(x−a)| = 2 atanh of the smaller of x/a and a/x; near the edge the plain form is exact.
  const double ratio = distance < a ? distance / a : a / distance;
  const double logarithm =
      ratio < 0.5 ? 2 * std::atanh(ratio) : std::log((distance + a) / std::abs(distance - a));
  const double magnitude = material.integral_compliance() * load.pressure() * logarithm;
  return x > 0 ? -magnitude : magnitude;
}

double normal_displacement(const Material& material, const UniformLoad& load, double x,
                           double datum) {
  const double a = load.half_width();
  const double scale = material.integral_compliance() * load.pressure() * a;
  const double here = edge_logarithms(std::abs(sys::require_finite("x", x)), a);
  const double there = edge_logarithms(std::abs(sys::require_finite("datum", datum)), a);
  return -scale * (here - there);
}

double tangential_gradient(const Material& material, const UniformLoad& load, double x) {
  const double distance = std::abs(sys::require_finite("x", x));
  if (distance > load.half_width()) return 0;
  const double inside = -material.local_compliance() * load.pressure();
  return distance == load.half_width() ? inside / 2 : inside;
}

double tangential_displacement(const Material& material, const UniformLoad& load, double x) {
  const double a = load.half_width();
  return -material.local_compliance() * load.pressure() *
         std::clamp(sys::require_finite("x", x), -a, a);
}

}  // namespace elasticity
