// SPDX-License-Identifier: GPL-3.0-or-later
// The basic integral of plane contact: the logarithmic potential of a pressure on the surface, for
// a triangle and for a uniform strip. The closed forms of these loads and the influence
// coefficients of the elements follow from it.
//
// ξ is the distance from the middle of the load. Every function takes any finite ξ unless it states
// otherwise.
#pragma once

namespace elasticity {

/// Φ(ξ) = ∫₋₁¹ (1−|σ|) ln|ξ−σ| dσ, the potential of a triangle of height 1:
///
///   Φ(ξ) = ½[(ξ+1)² ln|ξ+1| − 2ξ² ln|ξ| + (ξ−1)² ln|ξ−1|] − 3/2,  Φ(0) = −3/2, Φ → ln|ξ|.
///
/// Even. Accuracy: 4e-15 absolute times max(1, ln|ξ|) for |ξ| up to 1e9.
double triangle_potential(double xi);

/// Φ′(ξ) = (ξ+1) ln|ξ+1| − 2ξ ln|ξ| + (ξ−1) ln|ξ−1|, odd and finite everywhere. Accuracy: 1e-14
/// relative.
double triangle_gradient(double xi);

/// Φ(ξ+1) − Φ(ξ) for ξ ≥ 0. Accuracy: 1e-14 relative; subtracting two potentials would lose one
/// digit per digit of ξ.
double triangle_rise(double xi);

/// Ψ(ξ) = ∫ ln|ξ−σ| dσ from −½ to ½, the potential of a strip of width and height 1:
///
///   Ψ(ξ) = (ξ+½) ln|ξ+½| − (ξ−½) ln|ξ−½| − 1,  Ψ(0) = −1 − ln 2, Ψ → ln|ξ|   (Johnson 2.30a).
///
/// Even. Accuracy: as triangle_potential().
double strip_potential(double xi);

/// Ψ(ξ+1) − Ψ(ξ) = Φ′(ξ+½) for ξ ≥ 0. Accuracy: 1e-14 relative.
double strip_rise(double xi);

}  // namespace elasticity
