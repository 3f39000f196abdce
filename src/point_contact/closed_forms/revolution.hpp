// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace point_contact {

/// w − arctan w for w ≥ 0 without cancellation: 5e-16 relative. With w = tan t, tan t − t.
double excess_over_arctangent(double w);

/// A rigid cylinder's flat end pressed into a half-space: Boussinesq's closed form (Johnson §3.4,
/// eqs. 3.34–3.38).
class FlatPunch {
 public:
  /// contact_modulus E* (a stress), radius a and load P (a force), each > 0, or InvalidQuantity is
  /// thrown.
  FlatPunch(double contact_modulus, double radius, double load);

  /// δ = P/(2aE*), a length (Johnson 3.36).
  double approach() const { return approach_; }

  /// p(r) = P/(2πa √(a²−r²)) for r < a, infinite at the edge, 0 outside; a stress (Johnson 3.34).
  double pressure(double r) const;

  /// u_z1 + u_z2 = δ for r ≤ a, (2δ/π) arcsin(a/r) outside; a length (Johnson 3.37, 3.38).
  double displacement(double r) const;

 private:
  double radius_;
  double load_;
  double approach_;
};

/// A cone pressed into a half-space, h = r tan α: Love's and Sneddon's closed form (Sneddon 1948,
/// Proc. Camb. Phil. Soc. 44, 492; Johnson 5.17).
class Cone {
 public:
  /// contact_modulus E* (a stress), slope tan α and load P (a force), each > 0, or InvalidQuantity
  /// is thrown.
  Cone(double contact_modulus, double slope, double load);

  /// a = √(2P/(πE* tan α)), a length.
  double radius() const { return radius_; }

  /// δ = ½πa tan α, a length.
  double approach() const;

  /// p(r) = ½E* tan α arcosh(a/r) for r < a, 0 outside; a stress. Infinite at r = 0.
  double pressure(double r) const;

  /// The gap u_z1 + u_z2 + h − δ outside, a tan α [tan t − t] with cos t = a/r; 0 inside.
  double gap(double r) const;

 private:
  double contact_modulus_;
  double slope_;
  double radius_;
};

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
