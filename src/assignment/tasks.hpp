// SPDX-License-Identifier: GPL-3.0-or-later
// The tasks of the student's program as the checks ask for them: names, and inputs from a variant.
// All numbers are in SI units. This header is part of the handout, so it uses the standard library
// only.
#pragma once

#include "assignment/shapes.hpp"
#include "course/assignment/check.hpp"
#include "course/assignment/variant.hpp"

namespace assignment {

/// A half-space under a pressure: E, ν, p₀, a, the x where u_z = 0, and the shape of the pressure.
struct Surface {
  double young;
  double poisson;
  double peak_pressure;
  double half_width;
  double datum;
  Shape shape = Shape::triangle;
};

/// The first body of a variant, under the variant's triangle.
Surface surface_of(const course::Variant& variant);

/// «gradient»: ∂u_z/∂x at each x by eq. (3), which is for the triangle; the shape does not count.
course::Numbers ask_gradient(const course::Program& program, const Surface& surface,
                             const course::Numbers& x);

/// The answer of «gradient_by_quadrature»: ∂u_z/∂x at each x by eq. (2), and its error.
struct Quadratures {
  course::Numbers value;
  course::Numbers abs_error;
};
Quadratures ask_quadrature(const course::Program& program, const Surface& surface,
                           const course::Numbers& x);

/// «displacement»: u_z at each x.
course::Numbers ask_displacement(const course::Program& program, const Surface& surface,
                                 const course::Numbers& x);

/// «influence»: u_z1 + u_z2 at each of the whole numbers k of spacings from a triangle of pressure
/// 1.
course::Numbers ask_influence(const course::Program& program, double contact_modulus,
                              double spacing, double datum, const course::Numbers& k);

/// Two cylinders pressed together by a load per unit length, and the grid to find their pressure
/// on.
struct Cylinders {
  double young1, poisson1, radius1;
  double young2, poisson2, radius2;
  double line_load;
  double spacing;
  int n_nodes;
  double datum;

  double x(int i) const { return (i - (n_nodes - 1) / 2.0) * spacing; }
  /// E*, 1/E* = (1−ν₁²)/E₁ + (1−ν₂²)/E₂.
  double contact_modulus() const;
  /// 1/R₁ + 1/R₂.
  double relative_curvature() const { return 1 / radius1 + 1 / radius2; }
};

Cylinders cylinders_of(const course::Variant& variant);

/// The answer of «contact»: the approach δ, the half-width a, and the pressure at each node.
struct ContactAnswer {
  double approach;
  double half_width;
  course::Numbers pressure;
};
ContactAnswer ask_contact(const course::Program& program, const Cylinders& cylinders);

}  // namespace assignment
