// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace point_contact {

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

}  // namespace point_contact
