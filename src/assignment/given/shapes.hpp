// SPDX-License-Identifier: GPL-3.0-or-later
// The pressures of exercises 2 and 3, which the tasks name by number. This header is part of the
// handout, so it uses the standard library only.
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>

#include "assignment/given/student_types.hpp"

namespace assignment {

/// The shape of a pressure over ξ = s/a. It is zero for |ξ| > 1.
enum class Shape {
  triangle = 0,   ///< p₀(1 − |ξ|), eq. (4)
  smooth = 1,     ///< p₀(1 − ξ²)²
  one_sided = 2,  ///< p₀(1 − ξ²)(1 + ξ/2), greater on the right
};

/// The shape with this number. Throws std::invalid_argument if there is none.
inline Shape shape_of(double number) {
  for (const Shape shape : {Shape::triangle, Shape::smooth, Shape::one_sided}) {
    if (number == static_cast<double>(shape)) return shape;
  }
  throw std::invalid_argument("there is no pressure number " + std::to_string(number));
}

/// p(s) in Pa, with p₀ = unit_pressure and a = half_width.
inline double pressure(Shape shape, double unit_pressure, double half_width, double s) {
  const double at = s / half_width;
  if (std::abs(at) >= 1) return 0;
  const double parabola = (1 - at) * (1 + at);
  switch (shape) {
    case Shape::triangle:
      return unit_pressure * (1 - std::abs(at));
    case Shape::smooth:
      return unit_pressure * parabola * parabola;
    case Shape::one_sided:
      return unit_pressure * parabola * (1 + at / 2);
  }
  return 0;
}

/// The pressure that the numbers S p₀ a of a task name: S is the number of its shape, 0 for the
/// triangle, 1 for a smooth one, 2 for one that is not symmetric.
inline exercise::Load load_of(double number, double unit_pressure, double half_width) {
  const Shape shape = shape_of(number);
  const auto pressure_at = [=](double s) { return pressure(shape, unit_pressure, half_width, s); };
  return {pressure_at, half_width, unit_pressure};
}

}  // namespace assignment
