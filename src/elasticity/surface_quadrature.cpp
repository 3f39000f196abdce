// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/surface_quadrature.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "system/require.hpp"

namespace elasticity {

using numerics::Estimate;
using numerics::KernelIntegrals;

namespace {

double distance_to_force(const LineForce& force, double x) {
  if (x == force.position) {
    throw sys::InvalidQuantity("x", x, "away from the concentrated force");
  }
  return x - force.position;
}

double width_of(const numerics::PiecewiseFunction& pressure) {
  if (pressure.is_zero()) return 0;
  return pressure.pieces().back().end - pressure.pieces().front().begin;
}

// The points where a gradient has no Taylor series: the ends of all pieces.
std::vector<double> kinks_between(const Load& load, double low, double high) {
  std::vector<double> kinks;
  for (const numerics::Piece& piece : load.normal.pieces()) {
    for (const double end : {piece.begin, piece.end}) {
      if (end > low && end < high) kinks.push_back(end);
    }
  }
  std::sort(kinks.begin(), kinks.end());
  kinks.erase(std::unique(kinks.begin(), kinks.end()), kinks.end());
  return kinks;
}

}  // namespace

SurfaceQuadrature::SurfaceQuadrature(const Material& material, const Load& load, double datum)
    : material_(material),
      load_(load),
      datum_(sys::require_finite("datum", datum)),
      normal_(load.normal),
      constant_(-displacement_without_constant(datum)) {}

Estimate SurfaceQuadrature::normal_gradient(double x) const {
  Estimate integral = normal_.cauchy(x);
  for (const LineForce& force : load_.forces) {
    integral.value += force.magnitude / distance_to_force(force, x);
  }
  return -material_.integral_compliance() * integral;
}

Estimate SurfaceQuadrature::tangential_gradient(double x) const {
  return {elasticity::tangential_gradient(material_, load_, x), 0};
}

Estimate SurfaceQuadrature::normal_displacement(double x) const {
  return displacement_without_constant(x) + constant_;
}

Estimate SurfaceQuadrature::tangential_displacement(double x) const {
  const Estimate difference = 2.0 * normal_.integral_below(x) - normal_.total();
  Estimate sum = -material_.local_compliance() / 2 * difference;
  for (const LineForce& force : load_.forces) {
    const double side = std::copysign(1.0, distance_to_force(force, x));
    sum.value -= material_.local_compliance() / 2 * force.magnitude * side;
  }
  return sum;
}

Estimate SurfaceQuadrature::displacement_without_constant(double x) const {
  Estimate sum;
  if (!load_.normal.is_zero()) {
    // The unit of length is arbitrary, because C absorbs it; the width of the load keeps the
    // logarithm of order one
    sum = -material_.integral_compliance() * normal_.logarithmic(x, width_of(load_.normal));
  }
  for (const LineForce& force : load_.forces) {
    const double logarithm = std::log(std::abs(distance_to_force(force, x)));
    sum.value -= material_.integral_compliance() * force.magnitude * logarithm;
  }
  return sum;
}

Estimate SurfaceQuadrature::normal_displacement_from_gradient(double x) const {
  const auto [low, high] = std::minmax({sys::require_finite("x", x), datum_});
  for (const LineForce& force : load_.forces) {
    if (force.position >= low && force.position <= high) distance_to_force(force, force.position);
  }

  // Split at the kinks and midway between them, so that each part has a kink at one end at most.
  std::vector<double> nodes = kinks_between(load_, low, high);
  nodes.insert(nodes.begin(), low);
  nodes.push_back(high);
  Estimate sum;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const double middle = nodes[i] + (nodes[i + 1] - nodes[i]) / 2;
    sum += integrate_gradient(nodes[i], middle) - integrate_gradient(nodes[i + 1], middle);
  }
  return x < datum_ ? -sum : sum;
}

// ∫ (∂u_z/∂x) dx from begin to end, where the gradient may be infinite or kinked at or just before
// begin: the distance from begin is t = (end − begin) y⁴.
Estimate SurfaceQuadrature::integrate_gradient(double begin, double end) const {
  if (begin == end) return {};
  double inner_error = 0;
  const auto graded = [&](double y) {
    const double x = begin + (end - begin) * y * y * y * y;
    if (x == begin) return 0.0;  // x rounds to the kink; the weight y³ is below 1e-12
    const double weight = 4 * (end - begin) * y * y * y;
    const Estimate gradient = normal_gradient(x);
    inner_error = std::max(inner_error, std::abs(weight) * gradient.abs_error);
    return weight * gradient.value;
  };
  double scale = load_.normal.scale() * width_of(load_.normal);
  for (const LineForce& force : load_.forces) scale += std::abs(force.magnitude);
  const double abs_tolerance = 1e-12 * material_.integral_compliance() * scale;
  numerics::Quadrature quadrature;
  Estimate integral =
      quadrature.adaptive(graded, 0, 1, abs_tolerance, {"integral of the surface gradient", begin});
  integral.abs_error += inner_error;
  return integral;
}

}  // namespace elasticity
