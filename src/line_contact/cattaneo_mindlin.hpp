// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "line_contact/hertz.hpp"

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

}  // namespace line_contact
