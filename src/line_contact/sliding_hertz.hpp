// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "elasticity/stress.hpp"
#include "line_contact/hertz.hpp"

namespace line_contact {

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

}  // namespace line_contact
