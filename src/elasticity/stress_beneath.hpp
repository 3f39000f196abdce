// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "elasticity/stress.hpp"

namespace elasticity {

/// The stress at (x, z) in the half-space z > 0 in plane strain, beneath a pressure that is given
/// at nodes, linear between them and zero outside. {−a, a} with {p, p} is a strip load, {−a, 0, a}
/// with {0, p₀, 0} the triangle of eq. (4).
///
/// With w = x + iz and F(w) = ∫ p/(w−s) ds, Johnson (2.23) is
///
///   σ_xx = [Im F + Re zF′]/π,  σ_zz = [Im F − Re zF′]/π,  σ_xz = −Im zF′/π.
///
/// A segment from x₁ to x₂ with pressures p₁ and p₂ contributes, with L = ln[(w−x₁)/(w−x₂)],
/// m = (p₂−p₁)/(x₂−x₁) and p continued to p(w) = p₁ + m(w−x₁),
///
///   F = p(w) L − (p₂−p₁),  F′ = m L + p₁/(w−x₁) − p₂/(w−x₂)   (Johnson, section 2.5; derived).
///
/// From ten half-lengths on, where these terms cancel, Gauss's rule of six points takes their
/// place.
///
/// Nodes are lengths, two or more, rising, with as many pressures (stresses, of any sign); z ≥ 0.
/// InvalidQuantity is thrown otherwise, and at a point of the surface where the pressure jumps: the
/// stress has no limit there. On the rest of the surface the limit is returned. Accuracy: 1e-14 of
/// the greatest pressure, near the load and far from it. Cost: some 20 nanoseconds a node.
Stress stress_beneath(std::span<const double> nodes, std::span<const double> pressures, double x,
                      double z);

}  // namespace elasticity
