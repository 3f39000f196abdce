// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "point_contact/closed_forms/hertz.hpp"

namespace point_contact {

/// Two spheres in Hertz's contact, then loaded along x by less than friction can bear: partial slip
/// after Cattaneo (1938) and Mindlin (1949), in closed form (Johnson §7.2, eqs. 7.36–7.43).
///
/// A disk r < c sticks, the ring from c to a slips. For bodies of like elastic constants and a load
/// Q that only grows; the small traction across the load is neglected (exact for ν = 0).
class CattaneoMindlin {
 public:
  /// friction μ > 0; tangential_load Q, a force, |Q| < μP, 0 allowed. InvalidQuantity is thrown
  /// otherwise: from |Q| = μP on the spheres slide.
  CattaneoMindlin(const Hertz& normal, double friction, double tangential_load);

  /// c = a (1 − |Q|/(μP))^{1/3}, a length; a where Q = 0 (Johnson 7.38).
  double stick_radius() const { return stick_radius_; }

  /// The shear traction, a stress with the sign of Q, 0 outside (Johnson 7.36, 7.37):
  ///
  ///   q(r) = ± (μp₀/a) [√(a²−r²) − √(c²−r²)] = ± (μp₀/a) (a²−c²)/[√(a²−r²) + √(c²−r²)]  for r ≤ c,
  ///   q(r) = ± μ p(r)                                                              for c < r ≤ a.
  double traction(double r) const;

  /// The displacement of distant points along x, a length with the sign of Q (Johnson 7.43):
  ///
  ///   δ_x = (3μP/(16a)) C [1 − (1 − |Q|/(μP))^{2/3}],  C = (2−ν₁)/G₁ + (2−ν₂)/G₂.
  double displacement(double tangential_compliance) const;

 private:
  Hertz normal_;
  double friction_;
  double tangential_load_;
  double share_of_sliding_;
  double stick_radius_;
};

}  // namespace point_contact
