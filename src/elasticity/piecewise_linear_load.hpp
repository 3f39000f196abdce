// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "elasticity/load.hpp"
#include "elasticity/material.hpp"

namespace elasticity {

/// The logarithmic potentials ∫ N ln|u| du, each in the unit of u, of three pressures N on one
/// element begin ≤ u ≤ end. With half-length ℓ, z = (begin + end)/(2ℓ), u = ℓ(z + τ), |τ| ≤ 1:
struct ElementPotential {
  double begin;   ///< N = (1 − τ)/2, falls from 1 at the begin to 0 at the end
  double end;     ///< N = (1 + τ)/2, rises from 0 at the begin to 1 at the end
  double middle;  ///< N = 1 − τ², the parabola of height 1 between the two zeros
};

/// The potentials of an element as seen from x, by its distances begin = s₁ − x < end = s₂ − x:
///
///   ∫ ln|z+τ| dτ        = p ln|p| − m ln|m| − 2,                              p = z+1, m = z−1,
///   ∫ τ ln|z+τ| dτ      = z − ½ p m ln|p/m|,
///   ∫ (1−τ²) ln|z+τ| dτ = ⅓[p²(2−z) ln|p| + m²(2+z) ln|m|] + ⅔z² − 16/9,
///
/// from which N follows, with ln|u| = ln ℓ + ln|z+τ|. Derived from eq. (3)'s integral, whose
/// triangle is a rising and a falling element: two elements of unequal length side by side make an
/// unequal triangle (a hat), potential end₁ + begin₂.
///
/// Any finite begin < end (not checked; lengths in the unit that the logarithm is taken in), x at
/// an end of the element included. Beyond |z| = 2, where the closed forms cancel, their series in
/// 1/z² are summed. Accuracy: 2e-15 absolute in units of ℓ·max(1, |ln ℓ|, |ln far|), far the
/// distance from x of the element's farther end, against 50-digit arithmetic for 1e-12 ≤ ℓ ≤ 1e3
/// and distances up to 1e9 ℓ.
ElementPotential element_potential(double begin, double end);

/// The same with the length s₂ − s₁ as the ends themselves give it: seen from far away, begin and
/// end are rounded, and the difference of the two is less accurate than the potential.
ElementPotential element_potential(double begin, double end, double length);

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
