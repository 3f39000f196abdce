// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace line_contact {

/// A blunt wedge h = |x| tan α pressed onto a half-space, or two such: in closed form (Johnson
/// §5.2).
///
/// The slope tan α must be small for the half-space to be one. The pressure is infinite at x = 0,
/// as the logarithm, and its integral is not.
class Wedge {
 public:
  /// contact_modulus E* (stress), slope tan α and line_load P (force per unit length), each > 0, or
  /// InvalidQuantity is thrown.
  Wedge(double contact_modulus, double slope, double line_load);

  /// a = P/(E* tan α), a length.
  double half_width() const { return half_width_; }
  double line_load() const { return line_load_; }

  /// p(x) = (E* tan α/π) arcosh(a/|x|) for |x| ≤ a, infinite at x = 0, 0 outside; a stress.
  ///
  /// Accuracy: 5e-16 relative for |x|/a from 1e-300 to 1 − 1e-16, against 60-digit arithmetic.
  double pressure(double x) const;

  /// The gap u_z1 + u_z2 + h − δ that is left outside the contact, 0 inside; a length:
  ///
  ///   a tan α (2/π) [ξ arccos(1/ξ) − arcosh ξ],  ξ = |x|/a ≥ 1,
  ///
  /// whose slope is tan α (2/π) arccos(1/ξ), what eq. (2) leaves of h'.
  /// Accuracy: 4e-15 relative for ξ from 1 + 1e-15 to 1e6.
  double gap(double x) const;

 private:
  double slope_;
  double line_load_;
  double half_width_;
};

}  // namespace line_contact
