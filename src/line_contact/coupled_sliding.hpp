// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "line_contact/cylinder_pair.hpp"

namespace line_contact {

/// Two cylinders that slide, with the pressure that feels the shear: in closed form.
///
/// With the shear q = μp on body 1 and −μp on body 2, eq. (2) for both bodies and the slope of
/// eq. (1a) are, in contact,
///
///   (2/(πE*)) PV∫ p/(x−s) ds − (2βμ/E*) p = x/R,
///
/// a singular integral equation of the second kind (Johnson, section 7.1, for the equation; derived
/// by Muskhelishvili's method). β is Dundurs' second constant (elasticity::dundurs_beta). For
/// βμ = 0 it is Hertz's contact.
class CoupledSliding {
 public:
  /// line_load P > 0, force per unit length; friction μ finite, its sign that of the shear on
  /// body 1; dundurs_beta β finite. InvalidQuantity is thrown otherwise.
  CoupledSliding(const CylinderPair& cylinders, double line_load, double friction,
                 double dundurs_beta);

  /// γ, with tan πγ = −βμ and |γ| < 1/2.
  double gamma() const { return gamma_; }

  /// a, a length, from P = πE*a²(1−4γ²)/(4R).
  double half_width() const { return half_width_; }

  /// 2γa, a length: where the middle of the contact lies.
  double shift() const { return shift_; }

  /// p(x) = (E*/(2R)) cos πγ (a+t)^{1/2+γ} (a−t)^{1/2−γ} for |t| ≤ a, t = x − 2γa, 0 outside; a
  /// stress. Accuracy: 2e-15 relative, given a and t.
  double pressure(double x) const;

 private:
  double gamma_;
  double half_width_;
  double shift_;
  double factor_;  // (E*/(2R)) cos πγ
};

}  // namespace line_contact
