// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

namespace elasticity {

/// The stresses in the plane x, z of a body in plane strain; tension positive, z into the body.
///
/// xx, zz and xz are σ_xx, σ_zz and σ_xz in one unit of stress. On the surface z = 0 under a
/// pressure p, σ_zz = −p and σ_xz = 0. Functions of Poisson's ratio nu throw InvalidQuantity unless
/// −1 < ν ≤ 1/2.
struct Stress {
  double xx = 0;
  double zz = 0;
  double xz = 0;

  Stress& operator+=(const Stress& other);

  /// σ_yy = ν(σ_xx + σ_zz), the out-of-plane stress.
  double yy(double nu) const;

  /// τ₁ = √(((σ_xx − σ_zz)/2)² + σ_xz²), the greatest shear in the plane x, z; a stress ≥ 0.
  double max_shear() const;

  /// The three principal stresses (σ_xx + σ_zz)/2 ± τ₁ and σ_yy, the greatest first.
  std::array<double, 3> principal(double nu) const;

  /// Half the difference of the greatest and the least principal stress: the greatest shear in any
  /// plane (Tresca), a stress ≥ 0. It exceeds max_shear() where σ_yy is one of the two.
  double largest_shear(double nu) const;

  /// von Mises's equivalent stress √{½[(σ₁−σ₂)² + (σ₂−σ_yy)² + (σ_yy−σ₁)²]} in plane strain,
  ///
  ///   √(3τ₁² + (1−2ν)² ((σ_xx+σ_zz)/2)²)  with σ_yy = ν(σ_xx+σ_zz); a stress ≥ 0.
  ///
  /// Being a sum of squares, it loses no digits where the mean stress is large.
  double von_mises(double nu) const;
};

Stress operator*(double factor, const Stress& stress);

/// The stress at (x, z) in the half-space z > 0 in plane strain, beneath a pressure given at nodes,
/// linear between them and zero outside. Nodes {−a, a} with {p, p} make a uniform strip, {−a, 0, a}
/// with {0, p₀, 0} the triangle of eq. (4).
///
/// With w = x + iz and F(w) = ∫ p/(w−s) ds, Johnson (2.23) is
///
///   σ_xx = [Im F + Re zF′]/π,  σ_zz = [Im F − Re zF′]/π,  σ_xz = −Im zF′/π.
///
/// With L = ln[(w−x₁)/(w−x₂)], m = (p₂−p₁)/(x₂−x₁) and p extended to p(w) = p₁ + m(w−x₁), a segment
/// from x₁ to x₂ with pressures p₁ and p₂ contributes
///
///   F = p(w) L − (p₂−p₁),  F′ = m L + p₁/(w−x₁) − p₂/(w−x₂)   (Johnson, section 2.5; derived).
///
/// Beyond ten half-lengths these terms cancel, and Gauss's six-point rule replaces them.
///
/// `nodes` are two or more rising lengths, `pressures` as many stresses of any sign; z ≥ 0. Throws
/// InvalidQuantity otherwise, and at a point of the surface where the pressure jumps, because the
/// stress has no limit there. Elsewhere on the surface it returns the limit. Accuracy: 1e-14 of the
/// greatest pressure, near the load and far from it. Cost: about 20 nanoseconds per node.
Stress stress_beneath(std::span<const double> nodes, std::span<const double> pressures, double x,
                      double z);

}  // namespace elasticity
