// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "elasticity/load.hpp"
#include "elasticity/material.hpp"

namespace elasticity {

/// The triangular pressure p(x) = (p₀/a)(a − |x|) for |x| ≤ a. This is eq. (4) of the paper.
class TriangularLoad : public PeakedLoad {
 public:
  using PeakedLoad::PeakedLoad;

  /// The resultant p₀·a, force per unit length.
  double line_load() const { return peak_pressure() * half_width(); }

  operator Load() const;  // NOLINT(google-explicit-constructor): a triangular load is a load
};

/// ∂u_z/∂x at the surface of a half-space under a triangular load: the derivative of eq. (3),
///
///   ∂u_z/∂x = −K/a [(ξ+1) ln|ξ+1| + (ξ−1) ln|ξ−1| − 2ξ ln|ξ|],  ξ = x/a,  K = 2(1−ν²)p₀a/(πE).
///
/// Dimensionless; any finite x (length). At the kinks x = 0 and ±a it is the limit.
/// Accuracy: 1e-13 relative for |x|/a from 0 to 1e9, measured against 33-digit arithmetic.
double normal_gradient(const Material& material, const TriangularLoad& load, double x);

/// u_z at the surface of a half-space under a triangular load, with C such that u_z(datum) = 0.
/// This is eq. (3) of the paper:
///
///   u_z = −(1−ν²)/(2πE) (p₀/a) [(x+a)² ln((x+a)/a)² + (x−a)² ln((x−a)/a)² − 2x² ln(x/a)²] + C.
///
/// A length, positive into the body; any finite x and datum. Accuracy: 1e-14·K·(1 + ln(datum/a))
/// absolute for |x|/a up to 1e9, K as above.
double normal_displacement(const Material& material, const TriangularLoad& load, double x,
                           double datum);

/// u_x = −[(1−2ν)(1+ν)/(2E)] [∫_{s<x} p − ∫_{s>x} p], Johnson (2.24a) with q = 0: zero at x = 0,
/// ∓[(1−2ν)(1+ν)/(2E)] P outside the load on the right and left. A length, positive along x.
double tangential_displacement(const Material& material, const TriangularLoad& load, double x);

}  // namespace elasticity
