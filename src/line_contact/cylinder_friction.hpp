// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "elasticity/stress.hpp"
#include "line_contact/cylinders.hpp"

namespace line_contact {

/// Two cylinders in Hertz's contact, then loaded along x by less than friction can bear: partial
/// slip after Cattaneo and Mindlin, in closed form (Johnson §7.2, eqs. 7.24–7.28).
///
/// A strip |x| < c sticks, the strips from c to a on both sides slip. Exact for bodies of like
/// elastic constants, where the shear leaves the pressure alone; for a load Q that only grows.
class CattaneoMindlin {
 public:
  /// friction μ > 0; tangential_load Q, force per unit length, |Q| < μP, 0 allowed. InvalidQuantity
  /// is thrown otherwise: from |Q| = μP on the cylinders slide.
  CattaneoMindlin(const Hertz& normal, double friction, double tangential_load);

  /// a, a length: Hertz's.
  double half_width() const { return normal_.half_width(); }

  /// c = a √(1 − |Q|/(μP)), a length; a where Q = 0 (Johnson 7.28).
  double stick_half_width() const { return stick_half_width_; }
  double tangential_load() const { return tangential_load_; }

  /// The shear traction, a stress with the sign of Q (Johnson 7.24–7.26), 0 outside:
  ///
  ///   q(x) = ± (μp₀/a) [√(a²−x²) − √(c²−x²)] = (2Q/π)/[√(a²−x²) + √(c²−x²)]  for |x| ≤ c,
  ///   q(x) = ± μ p(x)                                                       for c < |x| ≤ a.
  ///
  /// Accuracy: 5e-16 relative where it sticks, given a and c, against 60-digit arithmetic; where it
  /// slips, that of Hertz::pressure.
  double traction(double x) const;

 private:
  Hertz normal_;
  double friction_;
  double tangential_load_;
  double stick_half_width_;
};

/// The stresses beneath cylinders that slide, with Hertz's pressure and the shear q = μp, in plane
/// strain and closed form. For μ = 0 they are McEwen's (class McEwen, which has more digits).
class SlidingHertz {
 public:
  /// friction μ, finite or InvalidQuantity is thrown; its sign is that of the shear on the body.
  SlidingHertz(const Hertz& hertz, double friction);

  /// The stress at (x, z), lengths, z > 0 into the body; tension positive. With w = x + iz,
  ///
  ///   F(w) = ∫ p/(w−s) ds = π(p₀/a)[w − √(w²−a²)],  G = μF,
  ///
  /// in the formulas of elasticity/interior_stress.hpp (Johnson 2.23; derived).
  ///
  /// Accuracy: 1e-14·p₀·(1 + |w|/a)² absolute, against McEwen and quadrature, down to depths of
  /// 1e-9 a. Throws InvalidQuantity for x not finite and unless z > 0 is finite.
  elasticity::Stress stress(double x, double z) const;

 private:
  double half_width_;
  double peak_pressure_;
  double friction_;
};

/// Two cylinders that slide, with the pressure that feels the shear: in closed form.
///
/// With the shear q = μp on body 1 and −μp on body 2, eq. (2) for both bodies and the slope of
/// eq. (1a) are, in contact,
///
///   (2/(πE*)) PV∫ p/(x−s) ds − (2βμ/E*) p = x/R,
///
/// a singular integral equation of the second kind (Johnson, section 7.1, for the equation; derived
/// by Muskhelishvili's method). β is Dundurs' second constant (elasticity::dundurs_beta). For
/// βμ = 0 it is Hertz's contact.
class CoupledSliding {
 public:
  /// line_load P > 0, force per unit length; friction μ finite, its sign that of the shear on
  /// body 1; dundurs_beta β finite. InvalidQuantity is thrown otherwise.
  CoupledSliding(const CylinderPair& cylinders, double line_load, double friction,
                 double dundurs_beta);

  /// γ, with tan πγ = −βμ and |γ| < 1/2.
  double gamma() const { return gamma_; }

  /// a, a length, from P = πE*a²(1−4γ²)/(4R).
  double half_width() const { return half_width_; }

  /// 2γa, a length: where the middle of the contact lies.
  double shift() const { return shift_; }

  /// p(x) = (E*/(2R)) cos πγ (a+t)^{1/2+γ} (a−t)^{1/2−γ} for |t| ≤ a, t = x − 2γa, 0 outside; a
  /// stress. Accuracy: 2e-15 relative, given a and t.
  double pressure(double x) const;

 private:
  double gamma_;
  double half_width_;
  double shift_;
  double factor_;  // (E*/(2R)) cos πγ
};

}  // namespace line_contact
