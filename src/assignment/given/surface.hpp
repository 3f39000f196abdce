// SPDX-License-Identifier: GPL-3.0-or-later
// The surface of exercises 1 to 4. This header is part of the handout, so it uses the standard
// library only.
#pragma once

#include "assignment/given/shapes.hpp"
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
inline Surface surface_of(const course::Variant& variant) {
  return {variant("young1"), variant("poisson1"), variant("peak_pressure"), variant("half_width"),
          variant("datum")};
}

}  // namespace assignment
