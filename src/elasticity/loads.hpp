// SPDX-License-Identifier: GPL-3.0-or-later
// Loads on the surface: any pressure, and those with closed forms.
#pragma once

#include <functional>
#include <vector>

#include "elasticity/material.hpp"
#include "numerics/piecewise.hpp"

namespace elasticity {

/// A force concentrated on a line of the surface.
struct LineForce {
  double position;   ///< x, a length
  double magnitude;  ///< P, force per unit length, positive into the body
};

/// A frictionless load on the surface of a body: any pressure p(s), a stress, and concentrated
/// forces.
///
/// The paper's named loads convert to it; distributed_load makes an arbitrary one.
struct Load {
  numerics::PiecewiseFunction normal;
  std::vector<LineForce> forces = {};
};

/// A load of arbitrary pressure p(s) on [breakpoints.front(), breakpoints.back()].
///
/// `breakpoints` (at least two, rising) are the ends of the load and every kink between them; p is
/// smooth between and continuous across them. Throws InvalidQuantity for breakpoints out of order
/// and for a pressure that is not finite there.
Load distributed_load(const std::function<double(double)>& pressure,
                      const std::vector<double>& breakpoints);

/// ∂u_x/∂x = −[(1−2ν)(1+ν)/E] p(x) at the surface of a half-space: Johnson (2.25a) with q = 0; at a
/// jump, the mean of both sides. Dimensionless; any finite x.
double tangential_gradient(const Material& material, const Load& load, double x);

/// The common base of loads on |x| ≤ a with a peak pressure p₀.
class PeakedLoad {
 public:
  /// peak_pressure p₀ (stress), half_width a (length). Throws InvalidQuantity unless both are > 0.
  PeakedLoad(double peak_pressure, double half_width);

  double peak_pressure() const { return peak_pressure_; }
  double half_width() const { return half_width_; }

 private:
  double peak_pressure_;
  double half_width_;
};

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

/// The uniform pressure p(x) = p₀ for |x| ≤ a, a strip load.
class UniformLoad : public PeakedLoad {
 public:
  using PeakedLoad::PeakedLoad;

  /// The resultant 2p₀a, force per unit length.
  double line_load() const { return 2 * peak_pressure() * half_width(); }

  operator Load() const;  // NOLINT(google-explicit-constructor): a uniform load is a load
};

/// ∂u_z/∂x = −[2(1−ν²)p₀/(πE)] ln|(x + a)/(x − a)| under a uniform load (eq. 2; Johnson, section
/// 2.5, derived).
///
/// Dimensionless. Throws InvalidQuantity at x = ±a, where the gradient is infinite because of the
/// step in traction for which the paper rejects uniform elements. Accuracy: 1e-14 relative.
double normal_gradient(const Material& material, const UniformLoad& load, double x);

/// u_z = −(1−ν²)p₀/(πE) [(x+a) ln((x+a)/a)² − (x−a) ln((x−a)/a)²] + C with u_z(datum) = 0 (Johnson,
/// section 2.5). A length, positive into the body; any finite x and datum.
///
/// Accuracy: 1e-14·K·(1 + ln(datum/a)) absolute, K = 4(1−ν²)p₀a/(πE).
double normal_displacement(const Material& material, const UniformLoad& load, double x,
                           double datum);

/// u_x = −[(1−2ν)(1+ν)/E] p₀ x under the load; outside it keeps its value at the edge. Johnson
/// (2.24a) with q = 0. A length, positive along x; any finite x.
double tangential_displacement(const Material& material, const UniformLoad& load, double x);

/// p(x) = p₀·[1 − (1 − e)|x|/a]: a pressure that falls linearly from its peak in the middle to the
/// fraction e of it at the edges. e = 0 gives the triangle of eq. (4), e = 1 a uniform load.
class LinearFall : public PeakedLoad {
 public:
  /// Throws InvalidQuantity unless p₀ (stress) and a (length) are > 0 and e ≥ 0.
  LinearFall(double peak_pressure, double edge_fraction, double half_width);

  double edge_fraction() const { return edge_fraction_; }

  /// The resultant (1 + e) p₀a, force per unit length.
  double line_load() const { return (1 + edge_fraction_) * peak_pressure() * half_width(); }

  operator Load() const;  // NOLINT(google-explicit-constructor): a linear fall is a load

 private:
  double edge_fraction_;
};

/// Displacements and gradients under a linear fall: (1 − e) times those of the triangle plus e
/// times those of the uniform load, with their units, domains and accuracy. The gradient is
/// infinite at x = ±a unless e = 0.
double normal_gradient(const Material& material, const LinearFall& load, double x);
double normal_displacement(const Material& material, const LinearFall& load, double x,
                           double datum);
double tangential_displacement(const Material& material, const LinearFall& load, double x);

/// A concentrated normal force P per unit length at x = 0.
class ConcentratedLoad {
 public:
  /// line_load P (force per unit length). Throws InvalidQuantity unless P > 0.
  explicit ConcentratedLoad(double line_load);

  double line_load() const { return line_load_; }

  operator Load() const;  // NOLINT(google-explicit-constructor): a concentrated load is a load

 private:
  double line_load_;
};

/// ∂u_z/∂x = −2(1−ν²)P/(πE x) under a concentrated force (Johnson, section 2.2).
///
/// Dimensionless. Throws InvalidQuantity at x = 0, where it is infinite.
double normal_gradient(const Material& material, const ConcentratedLoad& load, double x);

/// u_z = −2(1−ν²)P/(πE) ln|x/datum| (Johnson, section 2.2). A length, positive into the body.
///
/// Throws InvalidQuantity at x = 0 and for a datum of 0, where the displacement is infinite.
double normal_displacement(const Material& material, const ConcentratedLoad& load, double x,
                           double datum);

}  // namespace elasticity
