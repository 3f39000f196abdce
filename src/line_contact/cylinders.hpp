// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "elasticity/material.hpp"
#include "elasticity/stress.hpp"
#include "line_contact/problem.hpp"

namespace line_contact {

/// The shape of a body near the point of first contact: a cylinder, a plane or a cylindrical
/// hollow.
class Radius {
 public:
  /// A cylinder of radius > 0 (a length), or a hollow around the other body, radius < 0. Throws
  /// InvalidQuantity for `name` if the radius is 0 or not finite.
  static Radius of_cylinder(const char* name, double radius);

  /// A plane, whose curvature is 0.
  static Radius of_plane() { return Radius(0); }

  bool is_plane() const { return curvature_ == 0; }
  double curvature() const { return curvature_; }  ///< 1/R, 1/length; 0 for a plane

 private:
  explicit Radius(double curvature) : curvature_(curvature) {}
  double curvature_;
};

/// Two elastic cylinders with parallel axes, touching along a line.
class CylinderPair {
 public:
  /// Throws InvalidQuantity unless 1/R₁ + 1/R₂ > 0: otherwise the bodies do not touch at a point.
  CylinderPair(const elasticity::Material& material1, Radius radius1,
               const elasticity::Material& material2, Radius radius2);

  /// 1/R = 1/R₁ + 1/R₂, 1/length (Johnson 4.19).
  double relative_curvature() const { return relative_curvature_; }

  /// E*, 1/E* = (1−ν₁²)/E₁ + (1−ν₂²)/E₂, stress (Johnson 4.22).
  double contact_modulus() const { return contact_modulus_; }

  /// The gap before deformation h(x) = x²/(2R), a length: the paper's h in eqs. (1a) and (1b).
  Profile profile() const { return Profile::parabola(relative_curvature_); }

 private:
  double relative_curvature_;
  double contact_modulus_;
};

/// Hertz's closed form for two cylinders pressed together (Johnson 4.43–4.45).
class Hertz {
 public:
  /// line_load P, force per unit length. Throws InvalidQuantity unless P > 0.
  Hertz(const CylinderPair& cylinders, double line_load);

  /// a = √(4PR/(πE*)), a length (Johnson 4.43).
  double half_width() const { return half_width_; }

  /// p₀ = 2P/(πa), a stress (Johnson 4.45).
  double peak_pressure() const { return peak_pressure_; }

  /// p(x) = p₀ √(1 − x²/a²) for |x| ≤ a, 0 outside; a stress (Johnson 4.44).
  double pressure(double x) const;

  /// The approach δ of the points of the two surfaces at x = datum, where u_z1 = u_z2 = 0; a
  /// length. It is h(datum) minus the gap there: datum²/(2R) in contact, and outside
  ///
  ///   (a²/(2R)) [ξ/(ξ + √(ξ²−1)) + arcosh ξ],  ξ = |datum|/a,
  ///
  /// which is free of cancellation. Accuracy: 2e-15 relative. Throws InvalidQuantity for a datum
  /// that is not finite.
  double approach(double datum) const;

 private:
  double relative_curvature_;
  double half_width_;
  double peak_pressure_;
};

/// McEwen's closed form for the stresses beneath Hertz's pressure, without friction, in plane
/// strain (McEwen 1949; Johnson 4.49a–c).
class McEwen {
 public:
  explicit McEwen(const Hertz& hertz);

  /// The stress at (x, z), lengths, z ≥ 0 into the body; tension positive:
  ///
  ///   σ_xx = −(p₀/a) {m [1 + (z²+n²)/(m²+n²)] − 2z},
  ///   σ_zz = −(p₀/a) m [1 − (z²+n²)/(m²+n²)],
  ///   σ_xz = −(p₀/a) n (m²−z²)/(m²+n²),
  ///   m² − n² = a² − x² + z²,  mn = xz,  m ≥ 0, n with the sign of x.
  ///
  /// Computed from products and from sums of one sign. Accuracy: 2e-15 relative for each component,
  /// measured against 50-digit arithmetic at distances of 1e-9 a to 1e6 a from the axis, the
  /// surface and the edges. On the surface σ_xx = σ_zz = −p; at the edges it is the limit, 0.
  /// Squares of lengths must not overflow. Throws InvalidQuantity for x or z not finite, and for z
  /// < 0.
  elasticity::Stress stress(double x, double z) const;

 private:
  double half_width_;
  double peak_pressure_;
};

}  // namespace line_contact
