// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "elasticity/load.hpp"
#include "elasticity/material.hpp"

namespace elasticity {

/// The parabolic pressure p(x) = p₀ (1 − x²/a²) for |x| ≤ a.
class ParabolicLoad {
 public:
  /// peak_pressure p₀ (stress) and half_width a (length), both > 0, or InvalidQuantity is thrown.
  ParabolicLoad(double peak_pressure, double half_width);

  double peak_pressure() const { return peak_pressure_; }
  double half_width() const { return half_width_; }

  /// The resultant 4p₀a/3, force per unit length.
  double line_load() const { return 4 * peak_pressure_ * half_width_ / 3; }

  operator Load() const;  // NOLINT(google-explicit-constructor): a parabolic load is a load

 private:
  double peak_pressure_;
  double half_width_;
};

/// ∂u_z/∂x = −[2(1−ν²)p₀/(πE)] [2ξ + (1−ξ²) ln|(ξ+1)/(ξ−1)|], ξ = x/a (eq. 2), for |ξ| > 2 as the
/// series 4 Σ ξ^{−2k−1}/((2k+1)(2k+3)). Dimensionless; any finite x, ±a included. Accuracy: 1e-15
/// relative.
double normal_gradient(const Material& material, const ParabolicLoad& load, double x);

/// u_z = −[2(1−ν²)p₀a/(πE)] [Φ(x) − Φ(datum)], Φ(x) = ∫ (1−σ²) ln|ξ−σ| dσ from −1 to 1
/// (element_potential). A length, positive into the body; any finite x and datum. Accuracy: 1e-14
/// of the two terms.
double normal_displacement(const Material& material, const ParabolicLoad& load, double x,
                           double datum);

/// ∂u_x/∂x = −[(1−2ν)(1+ν)/E] p(x): Johnson (2.25a) with q = 0. Dimensionless; any finite x.
double tangential_gradient(const Material& material, const ParabolicLoad& load, double x);

/// u_x = −[(1−2ν)(1+ν)/(2E)] p₀a (2ξ − ⅔ξ³), Johnson (2.24a) with q = 0; outside as at the edge. A
/// length, positive along x.
double tangential_displacement(const Material& material, const ParabolicLoad& load, double x);

}  // namespace elasticity
