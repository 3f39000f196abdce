// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "elasticity/material.hpp"
#include "numerics/piecewise.hpp"

namespace elasticity {

/// A force concentrated on a line of the surface.
struct LineForce {
  double position;   ///< x, a length
  double magnitude;  ///< P, force per unit length, positive into the body
};

/// A frictionless load on the surface of a body: any pressure p(s), a stress, and concentrated
/// forces.
///
/// The paper's named loads convert to it; distributed_load makes an arbitrary one.
struct Load {
  numerics::PiecewiseFunction normal;
  std::vector<LineForce> forces = {};
};

/// A load of arbitrary pressure p(s) on [breakpoints.front(), breakpoints.back()].
///
/// `breakpoints` (at least two, rising) are the ends of the load and every kink between them; p is
/// smooth between and continuous across them. Throws InvalidQuantity for breakpoints out of order
/// and for a pressure that is not finite there.
Load distributed_load(const std::function<double(double)>& pressure,
                      const std::vector<double>& breakpoints);

/// ∂u_x/∂x = −[(1−2ν)(1+ν)/E] p(x) at the surface of a half-space: Johnson (2.25a) with q = 0; at a
/// jump, the mean of both sides. Dimensionless; any finite x.
double tangential_gradient(const Material& material, const Load& load, double x);

/// The common base of loads on |x| ≤ a with a peak pressure p₀.
class PeakedLoad {
 public:
  /// peak_pressure p₀ (stress), half_width a (length). Throws InvalidQuantity unless both are > 0.
  PeakedLoad(double peak_pressure, double half_width);

  double peak_pressure() const { return peak_pressure_; }
  double half_width() const { return half_width_; }

 private:
  double peak_pressure_;
  double half_width_;
};

}  // namespace elasticity
