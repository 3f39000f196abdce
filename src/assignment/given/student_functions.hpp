// SPDX-License-Identifier: GPL-3.0-or-later
// The functions that students write, one per file, with the types that they use. All numbers are in
// SI units; u_z is positive into the body. Equation numbers are those of the paper (B. Ruggiero
// 2001) and of sheet.pdf. This header is part of the handout.
#pragma once

#include <functional>
#include <vector>

namespace exercise {

struct Material {
  double young;    ///< E, Pa
  double poisson;  ///< ν
};

/// Any pressure p(s) on −a ≤ s ≤ a, given by its values. It is zero for |s| ≥ a, may have kinks at
/// 0 and ±a, is smooth elsewhere, and need not be symmetric.
struct Load {
  std::function<double(double)> pressure;  ///< p in Pa at any s in m
  double half_width;                       ///< a, m
  double unit_pressure;                    ///< p₀, Pa: the magnitude of p
};

/// A number and a bound on its error: the true value is in [value − abs_error, value + abs_error].
struct Estimate {
  double value;
  double abs_error;
};

// Exercise 1: the slope in closed form.

/// The triangular pressure of eq. (4), p(x) = (p₀/a)(a − |x|) for |x| ≤ a and 0 elsewhere.
struct TriangularLoad {
  double peak_pressure;  ///< p₀, Pa
  double half_width;     ///< a, m
};

/// ∂u_z/∂x of the surface under a triangular load, the derivative of eq. (3), with ξ = x/a:
///
///   ∂u_z/∂x = −[2(1−ν²)p₀/(πE)] [(ξ+1) ln|ξ+1| + (ξ−1) ln|ξ−1| − 2ξ ln|ξ|].
///
/// For any x, including the kinks 0 and ±a, where t ln|t| has the limit 0. Far from the load the
/// three terms are large and their sum is small. It must have eight correct digits even at 10⁸ a.
double normal_gradient(const Material& material, const TriangularLoad& load, double x);

// Exercise 2: the slope by numerical integration.

/// ∂u_z/∂x under any load from eq. (2), by numerical integration,
///
///   ∂u_z/∂x = −[2(1−ν²)/(πE)] PV∫ p(s)/(x−s) ds over −a ≤ s ≤ a,
///
/// a Cauchy principal value if x lies under the load. `value` must be accurate to 10⁻⁷ of the
/// greatest slope, and the true slope must lie within `abs_error` of it, even where GSL's own
/// estimate is too small. An error bound must be greater than zero and at most 10⁻⁶ of the greatest
/// slope. The same bound at all places of a load does not count if it exceeds 10⁻⁹ of that slope.
Estimate normal_gradient_by_quadrature(const Material& material, const Load& load, double x);

// Exercise 3: the displacement from a datum.

/// u_z of the surface under any load, zero at x = datum (and, if p is symmetric, at −datum):
/// eq. (2) integrated from the datum, or with the order of integration exchanged
///
///   u_z(x) = −[2(1−ν²)/(πE)] ∫ p(s) ln|(x−s)/(datum−s)| ds over −a ≤ s ≤ a,
///
/// by numerical integration. Must be accurate to 10⁻⁸ p₀a/E for any x and datum, including those
/// under the load.
double normal_displacement(const Material& material, const Load& load, double datum, double x);

// Exercise 4: influence coefficients.

/// The influence coefficient A_k: the displacement u_z1 + u_z2 of two surfaces k spacings away from
/// the peak of a triangle of pressure 1 Pa, whose half-width is the spacing c. It is zero at the
/// distance datum. By eq. (3), with E* instead of E/(1−ν²),
///
///   A_k = −[2c/(πE*)] [T(k) − T(datum/c)],
///   T(k) = ½[(k+1)² ln|k+1| + (k−1)² ln|k−1| − 2k² ln|k|] − 3/2.
///
/// k may be negative. T must be accurate to a relative 10⁻⁹ up to k = 10⁵.
double influence_coefficient(double contact_modulus, double spacing, double datum, int k);

// Exercise 5: two cylinders in contact.

/// Two cylinders with parallel axes; radii in m.
struct Cylinders {
  Material material1;
  double radius1;
  Material material2;
  double radius2;
};

/// Nodes x_i = (i − (n−1)/2) c, i = 0 … n−1, each at the peak of a triangle of half-width c.
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
/// with h = (x²/2)(1/R₁ + 1/R₂) and 1/E* = (1−ν₁²)/E₁ + (1−ν₂²)/E₂. Solve linear equations for the
/// nodes assumed to be in contact, remove the nodes with negative pressure, and solve again until
/// there are none. a = 2√⟨x²⟩, where ⟨x²⟩ = Σ p_i (x_i² + c²/6) / Σ p_i is the second moment of the
/// pressure, including that of each triangle about its own peak.
Contact solve_contact(const Cylinders& cylinders, const Grid& grid, double datum, double line_load);

/// Returns the x that solves matrix·x = right_side, by Gaussian elimination with partial pivoting.
/// Each entry of `matrix` is a row. This function is provided.
std::vector<double> solve_linear_equations(const std::vector<std::vector<double>>& matrix,
                                           const std::vector<double>& right_side);

}  // namespace exercise
