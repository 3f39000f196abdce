// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/load_shapes.hpp"

#include <algorithm>
#include <cmath>

#include "elasticity/line_potential.hpp"
#include "elasticity/triangular_load.hpp"
#include "system/require.hpp"

namespace elasticity {
namespace {

// Returns (1 − e) f(triangle) + e f(uniform load). For e = 0 the uniform load, whose gradient is
// infinite at the edge, is not evaluated.
template <class Function>
double superposed(const LinearFall& load, const Function& function) {
  const double e = load.edge_fraction();
  const TriangularLoad triangle(load.peak_pressure(), load.half_width());
  if (e == 0) return function(triangle);
  return (1 - e) * function(triangle) +
         e * function(UniformLoad(load.peak_pressure(), load.half_width()));
}

}  // namespace

UniformLoad::operator Load() const {
  Load load;
  load.normal = numerics::PiecewiseFunction(
      {{-half_width(), half_width(), [p = peak_pressure()](double) { return p; }}});
  return load;
}

double normal_gradient(const Material& material, const UniformLoad& load, double x) {
  const double a = load.half_width();
  const double distance = std::abs(sys::require_finite("x", x));
  if (distance == a) {
    throw sys::InvalidQuantity("x", x,
                               "away from the edge of the load, where the gradient is infinite");
  }
  // ln|(x+a)/(x−a)| = 2 artanh of the smaller of x/a and a/x; near the edge the logarithm itself is
  // accurate.
  const double ratio = distance < a ? distance / a : a / distance;
  const double logarithm =
      ratio < 0.5 ? 2 * std::atanh(ratio) : std::log((distance + a) / std::abs(distance - a));
  const double magnitude = material.integral_compliance() * load.peak_pressure() * logarithm;
  return x > 0 ? -magnitude : magnitude;
}

double normal_displacement(const Material& material, const UniformLoad& load, double x,
                           double datum) {
  const double width = 2 * load.half_width();
  const double here = strip_potential(sys::require_finite("x", x) / width);
  const double there = strip_potential(sys::require_finite("datum", datum) / width);
  return -material.integral_compliance() * load.line_load() * (here - there);
}

double tangential_displacement(const Material& material, const UniformLoad& load, double x) {
  const double a = load.half_width();
  return -material.local_compliance() * load.peak_pressure() *
         std::clamp(sys::require_finite("x", x), -a, a);
}

LinearFall::LinearFall(double peak_pressure, double edge_fraction, double half_width)
    : PeakedLoad(peak_pressure, half_width), edge_fraction_(edge_fraction) {
  if (!(std::isfinite(edge_fraction) && edge_fraction >= 0)) {
    throw sys::InvalidQuantity("edge_fraction", edge_fraction, "a finite number, 0 or more");
  }
}

LinearFall::operator Load() const {
  const auto pressure = [p0 = peak_pressure(), e = edge_fraction_, a = half_width()](double x) {
    const double t = std::abs(x) / a;
    return p0 * ((1 - t) + e * t);
  };
  return distributed_load(pressure, {-half_width(), 0, half_width()});
}

double normal_gradient(const Material& material, const LinearFall& load, double x) {
  return superposed(load, [&](const auto& part) { return normal_gradient(material, part, x); });
}

double normal_displacement(const Material& material, const LinearFall& load, double x,
                           double datum) {
  return superposed(
      load, [&](const auto& part) { return normal_displacement(material, part, x, datum); });
}

double tangential_displacement(const Material& material, const LinearFall& load, double x) {
  return superposed(load,
                    [&](const auto& part) { return tangential_displacement(material, part, x); });
}

}  // namespace elasticity
