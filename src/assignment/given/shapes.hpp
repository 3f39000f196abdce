// SPDX-License-Identifier: GPL-3.0-or-later
// The pressures of exercises 2 and 3, which tasks select by number. This header is part of the
// handout, so it uses the standard library only.
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>

#include "assignment/given/student_types.hpp"

namespace assignment {

/// Numbers of pressures over ξ = s/a, which are zero for |ξ| > 1. A number k from fewest_waves to
/// most_waves selects p₀(1 − ξ²)(1 + ½ sin kξ), for which there is no elementary closed form.
namespace shape {
inline constexpr double triangle = 0;   ///< p₀(1 − |ξ|), eq. (4)
inline constexpr double smooth = 1;     ///< p₀(1 − ξ²)²
inline constexpr double one_sided = 2;  ///< p₀(1 − ξ²)(1 + ξ/2), greater on the right
inline constexpr double fewest_waves = 3;
inline constexpr double most_waves = 12;
}  // namespace shape

/// Returns p(s) in Pa, with p₀ = unit_pressure and a = half_width. Throws std::invalid_argument if
/// no pressure has this number.
inline double pressure(double number, double unit_pressure, double half_width, double s) {
  const double at = s / half_width;
  if (std::abs(at) >= 1) return 0;
  const double parabola = (1 - at) * (1 + at);
  if (number == shape::triangle) return unit_pressure * (1 - std::abs(at));
  if (number == shape::smooth) return unit_pressure * parabola * parabola;
  if (number == shape::one_sided) return unit_pressure * parabola * (1 + at / 2);
  if (number >= shape::fewest_waves && number <= shape::most_waves) {
    return unit_pressure * parabola * (1 + std::sin(number * at) / 2);
  }
  throw std::invalid_argument("there is no pressure number " + std::to_string(number));
}

/// Makes the load from the inputs S, p₀ and a of a task, where S is the number of the pressure.
/// Throws std::invalid_argument if no pressure has this number.
inline exercise::Load load_of(double number, double unit_pressure, double half_width) {
  pressure(number, unit_pressure, half_width, 0);
  const auto pressure_at = [=](double s) { return pressure(number, unit_pressure, half_width, s); };
  return {pressure_at, half_width, unit_pressure};
}

}  // namespace assignment
