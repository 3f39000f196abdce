// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "point_contact/element.hpp"

namespace point_contact {

/// Hertz's closed form for two spheres pressed together (Johnson 4.22–4.24).
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

 private:
  double relative_curvature_;
  double radius_;
  double peak_pressure_;
};

/// Hertz's closed form for an elliptical contact: two bodies whose gap is h = (κ_x x² + κ_y y²)/2
/// (Johnson §4.2, eqs. 3.60–3.64, in Carlson's symmetric integrals R_F and R_D).
///
/// With semi-axes a along x and b along y, the displacement in contact is
///
///   u_z1 + u_z2 = (p₀ab/E*) [R_F(0, a², b²) − ⅓x² R_D(0, b², a²) − ⅓y² R_D(0, a², b²)].
///
/// Equating this to δ − h gives κ_x, κ_y and δ; the ratio b/a is solved from
/// κ_x/κ_y without approximation.
class HertzElliptic {
 public:
  /// contact_modulus E* (a stress), curvatures κ_x and κ_y (either may be the greater) and load P
  /// (a force). Throws InvalidQuantity unless each is > 0 and κ_x/κ_y lies between 1e-8 and 1e8.
  HertzElliptic(double contact_modulus, double curvature_x, double curvature_y, double load);

  /// a along x and b along y, lengths. Accuracy: 1e-14 relative.
  double semi_axis_x() const { return a_; }
  double semi_axis_y() const { return b_; }

  /// p₀ = 3P/(2πab), a stress.
  double peak_pressure() const { return peak_pressure_; }

  /// δ = (p₀ab/E*) R_F(0, a², b²), a length.
  double approach() const { return approach_; }

  /// p = p₀ √(1 − x²/a² − y²/b²) within the ellipse, 0 outside; a stress.
  double pressure(const Vector2& at) const;

 private:
  double a_, b_;
  double peak_pressure_;
  double approach_;
};

}  // namespace point_contact
