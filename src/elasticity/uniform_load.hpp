// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "elasticity/load.hpp"
#include "elasticity/material.hpp"

namespace elasticity {

/// The uniform pressure p(x) = p for |x| ≤ a.
class UniformLoad {
 public:
  /// pressure p (stress) and half_width a (length), both > 0, or InvalidQuantity is thrown.
  UniformLoad(double pressure, double half_width);

  double pressure() const { return pressure_; }
  double half_width() const { return half_width_; }

  /// The resultant 2pa, force per unit length.
  double line_load() const { return 2 * pressure_ * half_width_; }

  operator Load() const;  // NOLINT(google-explicit-constructor): a uniform load is a load

 private:
  double pressure_;
  double half_width_;
};

/// ∂u_z/∂x = −2(1−ν²)p/(πE) ln|(x + a)/(x − a)| under a uniform load (eq. 2; Johnson, section 2.5
/// derived).
///
/// Dimensionless. Throws InvalidQuantity at x = ±a, where the gradient is infinite: the step in
/// traction that the paper holds against uniform elements. Accuracy: 1e-14 relative.
double normal_gradient(const Material& material, const UniformLoad& load, double x);

/// u_z = −(1−ν²)p/(πE) [(x+a) ln((x+a)/a)² − (x−a) ln((x−a)/a)²] + C with u_z(datum) = 0 (Johnson,
/// section 2.5). A length, positive into the body; any finite x and datum.
///
/// Accuracy: 1e-14·K·(1 + ln(datum/a)) absolute, K = 4(1−ν²)pa/(πE).
double normal_displacement(const Material& material, const UniformLoad& load, double x,
                           double datum);

/// ∂u_x/∂x = −[(1−2ν)(1+ν)/E] p(x), Johnson (2.25a) with q = 0; at the edges half of what it is
/// inside. Dimensionless; any finite x.
double tangential_gradient(const Material& material, const UniformLoad& load, double x);

/// u_x = −[(1−2ν)(1+ν)/E] p x under the load, outside as at the edge: Johnson (2.24a) with q = 0. A
/// length, positive along x; any finite x.
double tangential_displacement(const Material& material, const UniformLoad& load, double x);

}  // namespace elasticity
