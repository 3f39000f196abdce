// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace elasticity {

/// The two principal stresses in the plane x, z; tension positive, greatest ≥ least.
struct PrincipalStresses {
  double greatest;
  double least;
};

/// The stresses in the plane x, z of a body in plane strain; tension positive, z into the body.
///
/// xx, zz and xz are σ_xx, σ_zz and σ_xz in one unit of stress. On the surface z = 0 under a
/// pressure p and a shear q, both as in Load, σ_zz = −p and σ_xz = −q.
struct Stress {
  double xx = 0;
  double zz = 0;
  double xz = 0;

  Stress& operator+=(const Stress& other);

  /// τ₁ = √(((σ_xx − σ_zz)/2)² + σ_xz²), the greatest shear in the plane x, z; a stress ≥ 0.
  double max_shear() const;

  /// σ₁,₂ = (σ_xx + σ_zz)/2 ± τ₁. The third is σ_yy = ν(σ_xx + σ_zz).
  PrincipalStresses principal() const;

  /// von Mises's equivalent stress √{½[(σ₁−σ₂)² + (σ₂−σ_yy)² + (σ_yy−σ₁)²]} in plane strain,
  ///
  ///   √(3τ₁² + (1−2ν)² ((σ_xx+σ_zz)/2)²)  with σ_yy = ν(σ_xx+σ_zz); a stress ≥ 0.
  ///
  /// A sum of squares, so it keeps its digits where the mean stress is large. nu is Poisson's
  /// ratio, −1 < ν ≤ 1/2 (at 1/2 only the shear counts); InvalidQuantity is thrown otherwise.
  double von_mises(double nu) const;
};

Stress operator+(Stress a, const Stress& b);
Stress operator*(double factor, const Stress& stress);

}  // namespace elasticity
