// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/concentrated_load.hpp"

#include <cmath>

#include "system/require.hpp"

namespace elasticity {
namespace {

double off_the_force(const char* quantity, double x) {
  if (sys::require_finite(quantity, x) == 0) {
    throw sys::InvalidQuantity(quantity, x, "away from the concentrated force");
  }
  return x;
}

}  // namespace

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
