// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "elasticity/stress.hpp"

namespace elasticity {

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
