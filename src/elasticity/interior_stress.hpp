// SPDX-License-Identifier: GPL-3.0-or-later
// Stresses inside the half-space z > 0 in plane strain, in closed form.
//
// Everywhere below, p is a pressure, positive into the body, and q a shear that acts on the body,
// positive in the direction of x, as in Load; both are stresses. x and z ≥ 0 are lengths, z into
// the body; stresses are tension positive. Johnson (2.23) is the sum of the line forces p ds and
// q ds at s,
//
//   σ_xx = −(2/π) ∫ [p t²z + q t³]/(t²+z²)² ds,
//   σ_zz = −(2/π) ∫ [p z³ + q t z²]/(t²+z²)² ds,
//   σ_xz = −(2/π) ∫ [p t z² + q t²z]/(t²+z²)² ds,      t = x − s,
//
// and with w = x + iz, F(w) = ∫ p/(w−s) ds and G(w) = ∫ q/(w−s) ds it is
//
//   σ_xx = [Im F + Re zF′ − 2 Re G + Im zG′]/π,
//   σ_zz = [Im F − Re zF′ − Im zG′]/π,
//   σ_xz = [−Im zF′ + Im G + Re zG′]/π.
//
// On the surface it is the limit: σ_zz = −p, σ_xz = −q, σ_xx = −p − (2/π) PV∫ q/(x−s) ds.
//
// Accuracy of a segment, measured against 50-digit arithmetic for distances and depths from 1e-9 to
// 1e6 lengths, at nodes and on the surface too: the error is below 1e-14 of the largest stress
// component for a pressure of one sign, and below 1e-14·max|q|·min(1, length/distance) for a shear
// (or a pressure that changes sign), which is the size of the stress under its line force |Q|. A
// sum over segments has the sum of these. A depth below 1e-60 widths of the load counts as that
// much, and squares of lengths must not overflow.
//
// Every function throws InvalidQuantity for x or z that is not finite, for z < 0, and at a point of
// the surface where a traction jumps: the stress has no limit there.
#pragma once

#include <span>
#include <vector>

#include "elasticity/stress.hpp"
#include "elasticity/triangular_load.hpp"

namespace elasticity {

/// Tractions that are linear on one segment [x1, x2] of the surface and zero elsewhere: a pressure
/// from p1 to p2 and a shear from q1 to q2. Constant ones are Johnson's uniform load; two segments
/// make a triangle.
struct LinearSegment {
  double x1;
  double x2;
  double p1;
  double p2;
  double q1 = 0;
  double q2 = 0;
};

/// The stress at (x, z) due to one segment: with L = ln[(w−x1)/(w−x2)], m = (p2−p1)/(x2−x1) and p
/// continued to p(w) = p1 + m(w−x1),
///
///   F = p(w) L − (p2−p1),   F′ = m L + p1/(w−x1) − p2/(w−x2)
///
/// (Johnson, section 2.5; derived). From ten half-lengths on, a series in half-length/(w − middle)
/// replaces the logarithm, whose terms would cancel. Throws InvalidQuantity also for x1 ≥ x2 or
/// anything that is not finite.
Stress stress_under(const LinearSegment& segment, double x, double z);

/// The stress at (x, z) under a triangular pressure (Johnson 2.36): with r and θ the distances and
/// angles (from the x-axis) of (x, z) seen from −a, 0 and a,
///
///   σ_xx = (p₀/πa) {(x+a)θ₋ + (x−a)θ₊ − 2xθ₀ + 2z ln(r₋r₊/r₀²)},
///   σ_zz = (p₀/πa) {(x+a)θ₋ + (x−a)θ₊ − 2xθ₀},   σ_xz = −(p₀z/πa) {θ₋ + θ₊ − 2θ₀},
///
/// computed as two segments. No points are excluded: the pressure is continuous.
Stress stress_under(const TriangularLoad& load, double x, double z);

/// Tractions given by their values at nodes, linear between and zero outside: overlapping
/// triangles, with halves of triangles at the two ends where the values there are not zero.
class PiecewiseLinearTraction {
 public:
  /// Nodes x (length; two or more, rising, any spacing), pressure p and shear q (stress; as many as
  /// nodes, or empty for none of it). Throws InvalidQuantity otherwise, and for values that are not
  /// finite.
  explicit PiecewiseLinearTraction(std::span<const double> nodes, std::span<const double> pressure,
                                   std::span<const double> shear = {});

  double pressure(double x) const;  ///< p(x), 0 outside the nodes
  double shear(double x) const;     ///< q(x), 0 outside the nodes

  /// The stress at (x, z): the sum over the segments between nodes, each as one LinearSegment.
  ///
  /// A logarithm and an angle are taken for the few segments nearer than ten half-lengths only, so
  /// the cost is some nanoseconds a node.
  Stress stress(double x, double z) const;

 private:
  double value(const std::vector<double>& traction, double x) const;

  std::vector<double> nodes_;
  std::vector<double> pressure_;
  std::vector<double> shear_;
};

}  // namespace elasticity
