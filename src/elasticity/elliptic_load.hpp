// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "elasticity/load.hpp"
#include "elasticity/material.hpp"

namespace elasticity {

/// Hertz's pressure p(x) = p₀ √(1 − x²/a²) for |x| ≤ a.
class EllipticLoad {
 public:
  /// peak_pressure p₀ (stress) and half_width a (length), both > 0, or InvalidQuantity is thrown.
  EllipticLoad(double peak_pressure, double half_width);

  double peak_pressure() const { return peak_pressure_; }
  double half_width() const { return half_width_; }

  /// The resultant ½πp₀a, force per unit length.
  double line_load() const;

  operator Load() const;  // NOLINT(google-explicit-constructor): an elliptic load is a load

 private:
  double peak_pressure_;
  double half_width_;
};

/// ∂u_z/∂x = −[2(1−ν²)p₀/E] ξ inside, ξ = x/a, and with ξ ∓ √(ξ²−1) in place of ξ outside (Johnson
/// 4.47, 4.48 derived). Dimensionless; any finite x. Accuracy: 1e-15 relative.
double normal_gradient(const Material& material, const EllipticLoad& load, double x);

/// u_z = −[(1−ν²)p₀a/E] [B(ξ) − B(datum/a)], B = ξ² inside and ξ/(ξ+s) + ln(ξ+s), s = √(ξ²−1),
/// outside, where ξ = |x|/a. A length, positive into the body; any finite x and datum. Accuracy:
/// 1e-15 of the two terms.
double normal_displacement(const Material& material, const EllipticLoad& load, double x,
                           double datum);

/// ∂u_x/∂x = −[(1−2ν)(1+ν)/E] p(x): Johnson (2.25a) with q = 0. Dimensionless; any finite x.
double tangential_gradient(const Material& material, const EllipticLoad& load, double x);

/// u_x = −[(1−2ν)(1+ν)/(2E)] p₀a [ξ √(1−ξ²) + arcsin ξ], Johnson (2.24a) with q = 0; outside as at
/// the edge. A length, positive along x.
double tangential_displacement(const Material& material, const EllipticLoad& load, double x);

}  // namespace elasticity
