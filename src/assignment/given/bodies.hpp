// SPDX-License-Identifier: GPL-3.0-or-later
// The surface of exercises 1 to 4 and the cylinders of exercises 4 and 5. This header is part of
// the handout, so it uses the standard library only.
#pragma once

#include <cmath>

#include "assignment/given/numbers.hpp"
#include "assignment/given/shapes.hpp"

namespace assignment {

/// A half-space under a pressure.
struct Surface {
  double young, poisson;           ///< E, ν
  double peak_pressure;            ///< p₀
  double half_width;               ///< a
  double datum;                    ///< the x at which u_z = 0
  double shape = shape::triangle;  ///< the number of the pressure's shape
};

/// The surface of body 1 under the triangle, with a student's numbers.
inline Surface surface_of(const OwnNumbers& own) {
  return {own.young1, own.poisson1, own.peak_pressure, own.half_width, own.datum};
}

/// Two cylinders pressed together by a load per unit length, and the grid for their pressure.
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

/// The two cylinders, their load and their grid, with a student's numbers.
inline Cylinders cylinders_of(const OwnNumbers& own) {
  return {own.young1,    own.poisson1, own.radius1,
          own.young2,    own.poisson2, own.radius2,
          own.line_load, own.spacing,  static_cast<int>(std::lround(own.nodes)),
          own.datum};
}

}  // namespace assignment
