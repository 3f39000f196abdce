// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/triangular_load.hpp"

#include <algorithm>
#include <cmath>

#include "elasticity/line_potential.hpp"
#include "system/require.hpp"

namespace elasticity {

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
  const double here = triangle_potential(sys::require_finite("x", x) / load.half_width());
  const double there = triangle_potential(sys::require_finite("datum", datum) / load.half_width());
  return -material.integral_compliance() * load.line_load() * (here - there);
}

double tangential_displacement(const Material& material, const TriangularLoad& load, double x) {
  // The resultant between −|x| and |x| is P (2ξ − ξ²) with ξ = min(|x|/a, 1).
  const double xi = std::min(1.0, std::abs(sys::require_finite("x", x)) / load.half_width());
  const double between = load.line_load() * xi * (2 - xi);
  const double magnitude = material.local_compliance() / 2 * between;
  return x > 0 ? -magnitude : magnitude;
}

}  // namespace elasticity
