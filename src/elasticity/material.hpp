// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace elasticity {

/// An isotropic elastic material in plane strain.
///
/// Units: any coherent system; young is a stress (psi, MPa, Pa).
class Material {
 public:
  /// Throws InvalidQuantity unless young > 0 is finite and −1 < poisson < 1/2.
  Material(double young, double poisson);

  double young() const { return young_; }      ///< E
  double poisson() const { return poisson_; }  ///< ν

  /// 2(1 − ν²)/(πE), the factor of the integrals in eq. (2); unit 1/stress.
  double integral_compliance() const;

  /// (1 − 2ν)(1 + ν)/E, the factor of the local terms in eq. (2) and Johnson (2.25a); 1/stress.
  double local_compliance() const;

 private:
  double young_;
  double poisson_;
};

/// The contact modulus E* of two materials, 1/E* = (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂ (Johnson 4.22); a
/// stress.
double contact_modulus(const Material& first, const Material& second);

/// Dundurs' second constant β = ½[(1−2ν₁)/G₁ − (1−2ν₂)/G₂]/[(1−ν₁)/G₁ + (1−ν₂)/G₂] (Johnson 5.3), 0
/// for identical materials; |β| ≤ 1/2 for ν ≥ 0.
double dundurs_beta(const Material& first, const Material& second);

}  // namespace elasticity
