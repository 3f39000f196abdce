// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "elasticity/load.hpp"
#include "elasticity/material.hpp"

namespace elasticity {

/// A pressure that is given at rising positions and linear between them, 0 outside: the sum of
/// unequal triangles about the positions.
class PiecewiseLinearLoad {
 public:
  /// positions x (lengths, two or more, rising) and as many pressures p (stresses, of any sign).
  /// InvalidQuantity is thrown otherwise, and for numbers that are not finite.
  PiecewiseLinearLoad(std::vector<double> positions, std::vector<double> pressures);

  const std::vector<double>& positions() const { return positions_; }
  const std::vector<double>& pressures() const { return pressures_; }

  /// From the first position to the last, a length.
  double width() const { return positions_.back() - positions_.front(); }

  /// ∫ p ds over s < x, force per unit length.
  double resultant_below(double x) const;

  operator Load() const;  // NOLINT(google-explicit-constructor): such a load is a load

 private:
  std::vector<double> positions_;
  std::vector<double> pressures_;
};

/// ∂u_z/∂x = −[2(1−ν²)/(πE)] Σ ∫ p ds/(x−s) over the elements between positions, with z = (centre −
/// x)/ℓ, ℓ half an element's length, and the pressure m + qτ on it, |τ| ≤ 1:
///
///   ∫ p ds/(x−s) = −[(m − qz) ln|(z+1)/(z−1)| + 2q]   (the derivative of eq. (3) for a triangle).
///
/// Dimensionless; any finite x, at a position the limit. Throws InvalidQuantity at an end where the
/// pressure is not 0: there the gradient is infinite. Accuracy: 1e-14 of the greatest term.
double normal_gradient(const Material& material, const PiecewiseLinearLoad& load, double x);

/// u_z with u_z(datum) = 0: eq. (3) for each of the unequal triangles, summed (element_potential).
/// A length, positive into the body; any finite x and datum. Accuracy: 1e-14 of the greatest term.
double normal_displacement(const Material& material, const PiecewiseLinearLoad& load, double x,
                           double datum);

/// u_x = −[(1−2ν)(1+ν)/(2E)] [∫_{s<x} p − ∫_{s>x} p], Johnson (2.24a) with q = 0. A length,
/// positive along x.
double tangential_displacement(const Material& material, const PiecewiseLinearLoad& load, double x);

}  // namespace elasticity
