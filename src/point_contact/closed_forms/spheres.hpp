// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace point_contact {

/// Hertz's closed form for two spheres pressed together (Johnson 4.22–4.24, 3.42).
class Hertz {
 public:
  /// contact_modulus E* (a stress), relative_curvature κ = 1/R₁ + 1/R₂ and load P (a force), each
  /// > 0, or InvalidQuantity is thrown.
  Hertz(double contact_modulus, double relative_curvature, double load);

  /// a = [3P/(4E*κ)]^{1/3}, a length (Johnson 4.22).
  double radius() const { return radius_; }

  /// p₀ = 3P/(2πa²), a stress (Johnson 4.24).
  double peak_pressure() const { return peak_pressure_; }

  /// δ = κa², a length (Johnson 4.23).
  double approach() const { return relative_curvature_ * radius_ * radius_; }

  double load() const { return load_; }

  /// p(r) = p₀ √(1 − r²/a²) for r ≤ a, 0 outside; a stress. Accuracy: a few roundings.
  double pressure(double r) const;

  /// The gap u_z1 + u_z2 + h − δ that is left outside the contact, 0 inside; a length:
  ///   (κa²/π) [t tan²t + tan t − t],  cos t = a/r   (from Johnson 3.42a).
  /// Accuracy: 1e-14 relative, given a.
  double gap(double r) const;

 private:
  double relative_curvature_;
  double load_;
  double radius_;
  double peak_pressure_;
};

/// Stresses in cylindrical coordinates r, θ, z about the axis of a point contact; tension positive,
/// z into the body, σ_zz = −p on the surface.
struct AxialStress {
  double rr;
  double tt;
  double zz;
  double rz;
};

/// The stresses in a body under Hertz's pressure of spheres: Huber (1904), Ann. Phys. 319, 153;
/// Johnson 3.45 on the axis, §3.4 on the surface.
///
/// With u the greater root of r²/(a²+u) + z²/u = 1 and w = z/√u, both free of cancellation:
///
///   σ_zz/p₀ = −w³ a²/(u + a²w²)
///   σ_rr/p₀ =  (1−2ν)/3 S + w³ a²/(u + a²w²) + w [(1−ν)u/(a²+u) + (1+ν)(√u/a) arctan(a/√u) − 2]
///   σ_θθ/p₀ = −(1−2ν)/3 S − w [2ν + (1−ν)u/(a²+u) − (1+ν)(√u/a) arctan(a/√u)]
///   σ_rz/p₀ = −r w² a² √u/[(u + a²w²)(a²+u)],   S = (a²/r²)(1 − w³) = a²(1+w+w²)/[(1+w)(a²+u)]
class Huber {
 public:
  /// nu is Poisson's ratio of the body, −1 < ν ≤ 1/2, or InvalidQuantity is thrown.
  Huber(const Hertz& normal, double nu);

  /// At r and depth z ≥ 0, lengths (InvalidQuantity for z < 0). Accuracy: 1e-15 p₀. At the
  /// contact's edge on the surface the limits along the surface are returned.
  AxialStress stress(double r, double z) const;

 private:
  Hertz normal_;
  double nu_;
};

}  // namespace point_contact
