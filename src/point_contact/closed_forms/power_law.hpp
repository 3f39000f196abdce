// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace point_contact {

/// Two bodies of revolution whose gap is h = A r^{2n}, pressed together: Steuermann's closed form
/// (Johnson 5.21–5.24). n = 1 is Hertz with A = κ/2; with growing n the pressure moves to the edge.
///
/// Below, k_n = (2n)!!/(2n−1)!! and T² = a² − r².
class PowerLaw {
 public:
  /// contact_modulus E* (a stress), coefficient A (length^{1−2n}) and load P (a force), each > 0,
  /// and n from 1 to Profile::max_power, or InvalidQuantity is thrown.
  PowerLaw(double contact_modulus, double coefficient, int n, double load);

  /// a = [(2n+1) P/(4n k_n A E*)]^{1/(2n+1)}, a length (Johnson 5.23).
  double radius() const { return radius_; }

  /// δ = k_n A a^{2n}, a length (Johnson 5.22).
  double approach() const;

  /// p(r) = (2n k_n A E*/π) Σ_{k<n} C(n−1, k) r^{2(n−1−k)} T^{2k+1}/(2k+1) for r ≤ a, 0 outside; a
  /// stress (Galin's integral of Johnson 5.21; all terms are positive). Accuracy: 1e-14 relative.
  double pressure(double r) const;

 private:
  double contact_modulus_;
  double coefficient_;
  int n_;
  double factor_;  // k_n
  double radius_;
};

}  // namespace point_contact
