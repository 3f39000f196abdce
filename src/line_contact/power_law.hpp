// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "line_contact/profile.hpp"

namespace line_contact {

/// Two bodies whose gap is h = A x^{2n}, pressed together: Steuermann's closed form (Johnson §5.3).
/// n = 1 is Hertz with A = 1/(2R); with growing n the bodies conform and the pressure moves to the
/// edges.
///
/// Below, c_k = (2k−1)!!/(2k)!!, c_0 = 1, and ξ = x/a.
class PowerLaw {
 public:
  /// contact_modulus E* (stress), coefficient A (length^{1−2n}) and line_load P (force per unit
  /// length), each > 0, and n from 1 to Profile::max_power, or InvalidQuantity is thrown.
  PowerLaw(double contact_modulus, double coefficient, int n, double line_load);

  /// The coefficient A = P/(πE* n c_n a^{2n}) that gives a contact of half-width a > 0 under the
  /// load P. Accuracy and errors as for half_width().
  static double coefficient_for(double contact_modulus, int n, double half_width, double line_load);

  /// a = [P/(πE* n A c_n)]^{1/(2n)}, a length.
  double half_width() const { return half_width_; }
  double line_load() const { return line_load_; }

  /// The largest pressure, a stress: at x = 0 for n = 1, else at two points ±x. Accuracy:
  /// 2e-15 relative.
  double peak_pressure() const;

  /// p(x) = P/(π c_n a) √(1 − ξ²) Σ_{k<n} c_k ξ^{2(n−1−k)} for |x| ≤ a, 0 outside; a stress.
  ///
  /// Accuracy: 3e-15 relative for |ξ| up to 1 − 1e-16 and every n, against 60-digit arithmetic.
  double pressure(double x) const;

  /// The gap u_z1 + u_z2 + h − δ that is left outside the contact, 0 inside; a length:
  ///
  ///   (2P/(πE* c_n)) Σ_{k<n} c_k I_{n−1−k},  I_m = ∫₁^ξ t^{2m} √(t²−1) dt,
  ///   I_0 = [ξ√(ξ²−1) − arcosh ξ]/2,  (2m+2) I_m = ξ^{2m−1} (ξ²−1)^{3/2} + (2m−1) I_{m−1}.
  ///
  /// Accuracy: 5e-15 relative for ξ from 1 + 1e-15 to 1e6.
  double gap(double x) const;

 private:
  double contact_modulus_;
  double line_load_;
  int n_;
  double load_coefficient_;  // c_n
  double half_width_;
};

}  // namespace line_contact
