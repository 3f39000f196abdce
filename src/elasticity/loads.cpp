// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/loads.hpp"

#include <algorithm>
#include <cmath>

#include "elasticity/line_potential.hpp"
#include "system/require.hpp"

namespace elasticity {

Load distributed_load(const std::function<double(double)>& pressure,
                      const std::vector<double>& breakpoints) {
  if (breakpoints.size() < 2) {
    throw sys::InvalidQuantity("number of breakpoints", static_cast<double>(breakpoints.size()),
                               "2 or more");
  }
  std::vector<numerics::Piece> pieces;
  for (std::size_t i = 0; i + 1 < breakpoints.size(); ++i) {
    pieces.push_back({breakpoints[i], breakpoints[i + 1], pressure});
  }
  return {numerics::PiecewiseFunction(pieces)};
}

double tangential_gradient(const Material& material, const Load& load, double x) {
  return -material.local_compliance() * load.normal(sys::require_finite("x", x));
}

PeakedLoad::PeakedLoad(double peak_pressure, double half_width)
    : peak_pressure_(sys::require_positive("peak_pressure", peak_pressure)),
      half_width_(sys::require_positive("half_width", half_width)) {}

namespace {

// u_z of a pressure whose potential is a function of x/length.
double displacement(const Material& material, double line_load, double (*potential)(double xi),
                    double length, double x, double datum) {
  const double here = potential(sys::require_finite("x", x) / length);
  const double there = potential(sys::require_finite("datum", datum) / length);
  return -material.integral_compliance() * line_load * (here - there);
}

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

double off_the_force(const char* quantity, double x) {
  if (sys::require_finite(quantity, x) == 0) {
    throw sys::InvalidQuantity(quantity, x, "away from the concentrated force");
  }
  return x;
}

}  // namespace

TriangularLoad::operator Load() const {
  const double p0 = peak_pressure();
  const double a = half_width();
  Load load;
  load.normal = numerics::PiecewiseFunction({
      {-a, 0, [=](double s) { return p0 / a * (a + s); }},
      {0, a, [=](double s) { return p0 / a * (a - s); }},
  });
  return load;
}

double normal_gradient(const Material& material, const TriangularLoad& load, double x) {
  const double xi = std::abs(sys::require_finite("x", x)) / load.half_width();
  const double magnitude =
      material.integral_compliance() * load.peak_pressure() * triangle_gradient(xi);
  return x > 0 ? -magnitude : magnitude;
}

double normal_displacement(const Material& material, const TriangularLoad& load, double x,
                           double datum) {
  return displacement(material, load.line_load(), triangle_potential, load.half_width(), x, datum);
}

double tangential_displacement(const Material& material, const TriangularLoad& load, double x) {
  // The resultant between −|x| and |x| is P (2ξ − ξ²) with ξ = min(|x|/a, 1).
  const double xi = std::min(1.0, std::abs(sys::require_finite("x", x)) / load.half_width());
  const double between = load.line_load() * xi * (2 - xi);
  const double magnitude = material.local_compliance() / 2 * between;
  return x > 0 ? -magnitude : magnitude;
}

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
  return displacement(material, load.line_load(), strip_potential, 2 * load.half_width(), x, datum);
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

ConcentratedLoad::ConcentratedLoad(double line_load)
    : line_load_(sys::require_positive("line_load", line_load)) {}

ConcentratedLoad::operator Load() const {
  Load load;
  load.forces = {{0, line_load_}};
  return load;
}

double normal_gradient(const Material& material, const ConcentratedLoad& load, double x) {
  return -material.integral_compliance() * load.line_load() / off_the_force("x", x);
}

double normal_displacement(const Material& material, const ConcentratedLoad& load, double x,
                           double datum) {
  const double ratio = off_the_force("x", x) / off_the_force("datum", datum);
  return -material.integral_compliance() * load.line_load() * std::log(std::abs(ratio));
}

}  // namespace elasticity
