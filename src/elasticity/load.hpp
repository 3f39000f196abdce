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

/// What acts on the surface of a body: any normal traction p(s), any tangential traction q(s), and
/// concentrated normal forces.
///
/// p is positive into the body (a pressure), q positive in the direction of x; both are stresses.
/// The named loads of the paper convert to this; an arbitrary one is made by distributed_load.
struct Load {
  numerics::PiecewiseFunction normal;
  numerics::PiecewiseFunction tangential;
  std::vector<LineForce> forces;
};

/// A load of arbitrary tractions p(s) and q(s) on [breakpoints.front(), breakpoints.back()].
///
/// `breakpoints` (at least two, rising) are the ends of the load and every kink between them; both
/// functions are smooth between and continuous across them. Leave one empty for none of it.
/// Throws InvalidQuantity for breakpoints out of order or tractions that are not finite there.
Load distributed_load(const std::function<double(double)>& pressure,
                      const std::function<double(double)>& shear,
                      const std::vector<double>& breakpoints);

/// ∂u_x/∂x = −[(1−2ν)(1+ν)/E] p(x) of a half-space's surface under any load without friction:
/// Johnson (2.25a) with q = 0; at a jump the mean of both sides. Dimensionless; any finite x.
double tangential_gradient(const Material& material, const Load& load, double x);

/// What loads on |x| ≤ a with a greatest pressure share.
class PeakedLoad {
 public:
  /// peak_pressure p₀ (stress) and half_width a (length), both > 0, or InvalidQuantity is thrown.
  PeakedLoad(double peak_pressure, double half_width);

  double peak_pressure() const { return peak_pressure_; }
  double half_width() const { return half_width_; }

 private:
  double peak_pressure_;
  double half_width_;
};

}  // namespace elasticity
