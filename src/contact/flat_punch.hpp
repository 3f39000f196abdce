// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace contact {

/// A flat punch with square edges, pressed onto a half-space without tilting and without friction:
/// in closed form (Johnson §2.8). The half-width is the punch's, whatever the load.
class FlatPunch {
 public:
  /// contact_modulus E* (stress), half_width a (length) and line_load P (force per unit length),
  /// each > 0, or InvalidQuantity is thrown.
  FlatPunch(double contact_modulus, double half_width, double line_load);

  double half_width() const { return half_width_; }
  double line_load() const { return line_load_; }

  /// p(x) = P/(π√(a² − x²)) for |x| < a, infinite at |x| = a, 0 outside; a stress (Johnson 2.64).
  ///
  /// Accuracy: 5e-16 relative for |x|/a up to 1 − 1e-16, against 60-digit arithmetic.
  double pressure(double x) const;

  /// δ − u_z1 − u_z2 ≥ 0, how far the surface beside the punch stands above the punch's face, 0
  /// inside; a length:
  ///   (2P/(πE*)) arcosh(|x|/a), the integral of eq. (2)'s slope outside.
  /// There is no gap to speak of: the punch has no face there.
  /// Accuracy: 5e-16 relative for |x|/a from 1 + 1e-15 to 1e6.
  double surface_rise(double x) const;

 private:
  double contact_modulus_;
  double half_width_;
  double line_load_;
};

}  // namespace contact
