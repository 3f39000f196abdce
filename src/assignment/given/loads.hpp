// SPDX-License-Identifier: GPL-3.0-or-later
// How the tasks of exercises 2 and 3 name a pressure. This header is part of the handout.
#pragma once

#include "assignment/given/shapes.hpp"
#include "assignment/given/student_types.hpp"

namespace assignment {

/// The pressure that the numbers S p₀ a of a task name: S is the number of its shape, 0 for the
/// triangle, 1 for a smooth one, 2 for one that is not symmetric.
inline exercise::Load load_of(double number, double unit_pressure, double half_width) {
  const Shape shape = shape_of(number);
  const auto pressure_at = [=](double s) { return pressure(shape, unit_pressure, half_width, s); };
  return {pressure_at, half_width, unit_pressure};
}

}  // namespace assignment
