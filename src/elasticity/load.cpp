// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/load.hpp"

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

}  // namespace elasticity
