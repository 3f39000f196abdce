// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace elasticity {

/// The logarithmic potentials ∫ N ln|u| du, each in the unit of u, of three pressures N on one
/// element begin ≤ u ≤ end. With half-length ℓ, z = (begin + end)/(2ℓ), u = ℓ(z + τ), |τ| ≤ 1:
struct ElementPotential {
  double begin;   ///< N = (1 − τ)/2, falls from 1 at the begin to 0 at the end
  double end;     ///< N = (1 + τ)/2, rises from 0 at the begin to 1 at the end
  double middle;  ///< N = 1 − τ², the parabola of height 1 between the two zeros
};

/// The potentials of an element as seen from x, by its distances begin = s₁ − x < end = s₂ − x:
///
///   ∫ ln|z+τ| dτ        = p ln|p| − m ln|m| − 2,                              p = z+1, m = z−1,
///   ∫ τ ln|z+τ| dτ      = z − ½ p m ln|p/m|,
///   ∫ (1−τ²) ln|z+τ| dτ = ⅓[p²(2−z) ln|p| + m²(2+z) ln|m|] + ⅔z² − 16/9,
///
/// from which N follows, with ln|u| = ln ℓ + ln|z+τ|. Derived from eq. (3)'s integral, whose
/// triangle is a rising and a falling element: two elements of unequal length side by side make an
/// unequal triangle (a hat), potential end₁ + begin₂.
///
/// Any finite begin < end (not checked; lengths in the unit that the logarithm is taken in), x at
/// an end of the element included. Beyond |z| = 2, where the closed forms cancel, their series in
/// 1/z² are summed. Accuracy: 2e-15 absolute in units of ℓ·max(1, |ln ℓ|, |ln far|), far the
/// distance from x of the element's farther end, against 50-digit arithmetic for 1e-12 ≤ ℓ ≤ 1e3
/// and distances up to 1e9 ℓ.
ElementPotential element_potential(double begin, double end);

/// The same with the length s₂ − s₁ as the ends themselves give it: seen from far away, begin and
/// end are rounded, and the difference of the two is less accurate than the potential.
ElementPotential element_potential(double begin, double end, double length);

}  // namespace elasticity
