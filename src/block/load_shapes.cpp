// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/load_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "numerics/kernel_integrals.hpp"
#include "system/require.hpp"

namespace block {
namespace {

// Returns the pressure peak·shape(|x|/a), which has breakpoints at the given fractions of a on both
// sides.
elasticity::Load symmetric_load(double peak, double half_width,
                                const std::vector<double>& breakpoints,
                                const std::function<double(double)>& shape) {
  sys::require_positive("peak", peak);
  sys::require_positive("half_width", half_width);
  std::vector<double> ends;
  for (const double fraction : breakpoints) ends.push_back(fraction * half_width);
  return elasticity::distributed_load(
      [=](double x) { return peak * shape(std::abs(x) / half_width); }, nullptr, ends);
}

numerics::PiecewiseFunction scaled(const numerics::PiecewiseFunction& function, double factor) {
  std::vector<numerics::Piece> pieces = function.pieces();
  for (numerics::Piece& piece : pieces) {
    piece.value = [factor, value = piece.value](double s) { return factor * value(s); };
  }
  return numerics::PiecewiseFunction(pieces);
}

}  // namespace

elasticity::Load linear_fall(double peak, double edge_fraction, double half_width) {
  if (!(std::isfinite(edge_fraction) && edge_fraction >= 0)) {
    throw sys::InvalidQuantity("edge_fraction", edge_fraction, "a finite number, 0 or more");
  }
  return symmetric_load(peak, half_width, {-1, 0, 1},
                        [=](double t) { return (1 - t) + edge_fraction * t; });
}

elasticity::Load elliptic(double peak, double half_width) {
  return symmetric_load(peak, half_width, {-1, 1},
                        [](double t) { return std::sqrt(std::max(0.0, (1 - t) * (1 + t))); });
}

elasticity::Load power_fall(double peak, double exponent, double half_width) {
  sys::require_positive("exponent", exponent);
  // An even power of |x| is smooth in the middle; any other has a kink or a root there
  const std::vector<double> ends =
      std::fmod(exponent, 2) == 0 ? std::vector<double>{-1, 1} : std::vector<double>{-1, 0, 1};
  return symmetric_load(peak, half_width, ends,
                        [=](double t) { return 1 - std::pow(t, exponent); });
}

elasticity::Load cosine_fall(double peak, double half_width) {
  return symmetric_load(peak, half_width, {-1, 1},
                        [](double t) { return (1 + std::cos(std::numbers::pi * t)) / 2; });
}

elasticity::Load scaled(const elasticity::Load& load, double factor) {
  sys::require_finite("factor", factor);
  elasticity::Load result{scaled(load.normal, factor), scaled(load.tangential, factor),
                          load.forces};
  for (elasticity::LineForce& force : result.forces) force.magnitude *= factor;
  return result;
}

double normal_resultant(const elasticity::Load& load) {
  double sum = numerics::KernelIntegrals(load.normal).total().value;
  for (const elasticity::LineForce& force : load.forces) sum += force.magnitude;
  return sum;
}

}  // namespace block
