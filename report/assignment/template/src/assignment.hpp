// SPDX-License-Identifier: GPL-3.0-or-later
// The functions that you write, one file each. Equation numbers are those of the paper (B. Ruggiero
// 2001) and of sheet.pdf. All numbers are in SI units; u_z is positive into the body.
#pragma once

#include <functional>
#include <vector>

#include "numerics/estimate.hpp"

namespace exercise {

struct Material {
  double young;    ///< E, Pa
  double poisson;  ///< ν
};

/// The triangular pressure of eq. (4), p(x) = (p₀/a)(a − |x|) for |x| ≤ a and 0 elsewhere.
struct TriangularLoad {
  double peak_pressure;  ///< p₀, Pa
  double half_width;     ///< a, m
};

/// Any pressure p(s) on −a ≤ s ≤ a. It is zero at ±a and outside, has kinks at 0 and ±a at most, is
/// smooth elsewhere, and need not be symmetric. It is known only by its values.
struct Load {
  std::function<double(double)> pressure;  ///< p in Pa at any s in m
  double half_width;                       ///< a, m
  double unit_pressure;                    ///< p₀, Pa: the order of p's greatest value
};

/// ∂u_z/∂x of the surface under a triangular load, the derivative of eq. (3), with ξ = x/a:
///
///   ∂u_z/∂x = −[2(1−ν²)p₀/(πE)] [(ξ+1) ln|ξ+1| + (ξ−1) ln|ξ−1| − 2ξ ln|ξ|].
///
/// For any x, the kinks 0 and ±a included, where t ln|t| has the limit 0. Far from the load the
/// three terms are large and their sum is small: it must be right to eight digits at 10⁸ a too.
double normal_gradient(const Material& material, const TriangularLoad& load, double x);

/// ∂u_z/∂x under any load from eq. (2), by numerical integration,
///
///   ∂u_z/∂x = −[2(1−ν²)/(πE)] PV∫ p(s)/(x−s) ds over −a ≤ s ≤ a,
///
/// a Cauchy principal value where x lies under the load. `value` is to be good to 10⁻⁷ of the
/// greatest slope, and the truth must lie within `abs_error` of it, also where GSL's own estimate
/// leaves something out; an error that is zero, or more than 10⁻⁶ of the greatest slope, is no use.
numerics::Estimate normal_gradient_by_quadrature(const Material& material, const Load& load,
                                                 double x);

/// u_z of the surface under any load, zero at x = datum (and, if p is symmetric, at −datum):
/// eq. (2) integrated from the datum, or with the order of integration exchanged
///
///   u_z(x) = −[2(1−ν²)/(πE)] ∫ p(s) ln|(x−s)/(datum−s)| ds over −a ≤ s ≤ a,
///
/// by numerical integration. Good to 10⁻⁸ of p₀a/E. Any x and datum, under the load as well.
double normal_displacement(const Material& material, const Load& load, double datum, double x);

/// The influence coefficient A_k: u_z1 + u_z2 of two surfaces k spacings away from the peak of a
/// triangle of pressure 1 Pa, whose half-width is the spacing c, zero at the distance datum. By
/// eq. (3), with E* in place of E/(1−ν²),
///
///   A_k = −[2c/(πE*)] [T(k) − T(datum/c)],
///   T(k) = ½[(k+1)² ln|k+1| + (k−1)² ln|k−1| − 2k² ln|k|] − 3/2.
///
/// k may be negative. T is to be good to 10⁻⁹ up to k = 10⁵.
double influence_coefficient(double contact_modulus, double spacing, double datum, int k);

/// Two cylinders with parallel axes; radii in m.
struct Cylinders {
  Material material1;
  double radius1;
  Material material2;
  double radius2;
};

/// Nodes x_i = (i − (n−1)/2) c, i = 0 … n−1, each the middle of a triangle of half-width c.
struct Grid {
  int n_nodes;
  double spacing;  ///< c, m

  double x(int i) const { return (i - (n_nodes - 1) / 2.0) * spacing; }
};

struct Contact {
  double approach;               ///< δ, m
  double half_width;             ///< a, m
  std::vector<double> pressure;  ///< p_i at the nodes, Pa; 0 where the surfaces do not touch
};

/// The contact of two cylinders under the load P per unit length (N/m), eqs. (1a) and (1b):
///
///   Σ_j A_{i−j} p_j + h_i − δ = 0 and p_i > 0  at the nodes in contact,
///   Σ_j A_{i−j} p_j + h_i − δ ≥ 0 and p_i = 0  at the others,      c Σ_j p_j = P,
///
/// with h = (x²/2)(1/R₁ + 1/R₂) and 1/E* = (1−ν₁²)/E₁ + (1−ν₂²)/E₂. Solved as linear equations for
/// the nodes thought to be in contact; pressures that come out negative are left out, and it is
/// solved again. a = 2√⟨x²⟩, where ⟨x²⟩ = Σ p_i (x_i² + c²/6) / Σ p_i is the second moment of the
/// pressure, the triangles' own included.
Contact solve_contact(const Cylinders& cylinders, const Grid& grid, double datum, double line_load);

}  // namespace exercise
