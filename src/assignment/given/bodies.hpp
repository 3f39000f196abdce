// SPDX-License-Identifier: GPL-3.0-or-later
// The surface of exercises 1 to 4 and the cylinders of exercises 4 and 5. This header is part of
// the handout, so it uses the standard library only.
#pragma once

#include <cmath>

#include "assignment/given/shapes.hpp"
#include "course/assignment/variant.hpp"

namespace assignment {

/// A half-space under a pressure: E, ν, p₀, a, the x where u_z = 0, and the number of
/// the pressure's shape.
struct Surface {
  double young;
  double poisson;
  double peak_pressure;
  double half_width;
  double datum;
  double shape = shape::triangle;
};

/// The first body of a variant, under the variant's triangle.
inline Surface surface_of(const course::Variant& variant) {
  return {variant("young1"), variant("poisson1"), variant("peak_pressure"), variant("half_width"),
          variant("datum")};
}

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
  double contact_modulus() const {
    return 1 / ((1 - poisson1 * poisson1) / young1 + (1 - poisson2 * poisson2) / young2);
  }
  /// 1/R₁ + 1/R₂.
  double relative_curvature() const { return 1 / radius1 + 1 / radius2; }
};

/// The two bodies of a variant, with its load and grid.
inline Cylinders cylinders_of(const course::Variant& variant) {
  return {
      variant("young1"),    variant("poisson1"), variant("radius1"),
      variant("young2"),    variant("poisson2"), variant("radius2"),
      variant("line_load"), variant("spacing"),  static_cast<int>(std::lround(variant("nodes"))),
      variant("datum")};
}

}  // namespace assignment
