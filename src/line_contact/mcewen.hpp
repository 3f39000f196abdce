// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "elasticity/stress.hpp"
#include "line_contact/hertz.hpp"

namespace line_contact {

/// The greatest shear beneath a contact and where it is found.
struct GreatestShear {
  double shear;  ///< τ₁, a stress
  double depth;  ///< z on the axis x = 0, a length
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
  /// Computed as products and sums of one sign: 2e-15 relative for each component, for distances
  /// from 1e-9 a to 1e6 a from the axis, the surface and the edges, measured against 50-digit
  /// arithmetic. On the surface σ_xx = σ_zz = −p. At the edges it is the limit, 0. Squares of
  /// lengths must not overflow. Throws InvalidQuantity for x or z not finite, and for z < 0.
  elasticity::Stress stress(double x, double z) const;

  /// The greatest shear in the whole body, which lies on the axis, as the contact is without
  /// friction: τ₁ = p₀ φ^(−5/2) = 0.300283 p₀ at z = a/√φ = a √((√5 − 1)/2) = 0.786151 a, with φ
  /// the golden ratio; to some roundings. (Johnson, section 4.2: 0.30 p₀ at 0.78 a.)
  GreatestShear greatest_shear() const;

 private:
  double half_width_;
  double peak_pressure_;
};

}  // namespace line_contact
