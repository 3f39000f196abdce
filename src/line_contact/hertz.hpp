// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "line_contact/cylinder_pair.hpp"

namespace line_contact {

/// Hertz's closed form for two cylinders pressed together (Johnson 4.43–4.45).
class Hertz {
 public:
  /// line_load P > 0, force per unit length, or InvalidQuantity is thrown.
  Hertz(const CylinderPair& cylinders, double line_load);

  /// a = √(4PR/(πE*)), a length (Johnson 4.43).
  double half_width() const { return half_width_; }

  /// p₀ = 2P/(πa), a stress (Johnson 4.45).
  double peak_pressure() const { return peak_pressure_; }

  /// p(x) = p₀ √(1 − x²/a²) for |x| ≤ a, 0 outside; a stress (Johnson 4.44).
  double pressure(double x) const;

  /// The gap u_z1 + u_z2 + h − δ that is left outside the contact, 0 inside; a length:
  ///   (a²/(2R)) [ξ √(ξ²−1) − arcosh ξ], ξ = |x|/a ≥ 1, the integral of eq. (2)'s slope outside.
  double gap(double x) const;

  /// The approach δ of points of the two surfaces that lie at x = datum, where u_z1 = u_z2 = 0; a
  /// length. It is h(datum) less the gap there: datum²/(2R) in contact, and outside
  ///
  ///   (a²/(2R)) [ξ/(ξ + √(ξ²−1)) + arcosh ξ],  ξ = |datum|/a,
  ///
  /// in which nothing cancels. Accuracy: 2e-15 relative. Throws InvalidQuantity for a datum that is
  /// not finite.
  double approach(double datum) const;

 private:
  double relative_curvature_;
  double half_width_;
  double peak_pressure_;
};

}  // namespace line_contact
