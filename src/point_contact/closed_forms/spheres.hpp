// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace point_contact {

/// Hertz's closed form for two spheres pressed together (Johnson 4.22–4.24, 3.42).
class Hertz {
 public:
  /// contact_modulus E* (a stress), relative_curvature κ = 1/R₁ + 1/R₂ and load P (a force). Throws
  /// InvalidQuantity unless each is > 0.
  Hertz(double contact_modulus, double relative_curvature, double load);

  /// a = [3P/(4E*κ)]^{1/3}, a length (Johnson 4.22).
  double radius() const { return radius_; }

  /// p₀ = 3P/(2πa²), a stress (Johnson 4.24).
  double peak_pressure() const { return peak_pressure_; }

  /// δ = κa², a length (Johnson 4.23).
  double approach() const { return relative_curvature_ * radius_ * radius_; }

  /// p(r) = p₀ √(1 − r²/a²) for r ≤ a, 0 outside; a stress. Accuracy: a few roundings.
  double pressure(double r) const;

  /// The gap u_z1 + u_z2 + h − δ outside the contact, 0 inside; a length:
  ///   (κa²/π) [t tan²t + tan t − t],  cos t = a/r   (from Johnson 3.42a).
  /// Accuracy: 1e-14 relative, given a.
  double gap(double r) const;

 private:
  double relative_curvature_;
  double radius_;
  double peak_pressure_;
};

}  // namespace point_contact
