// SPDX-License-Identifier: GPL-3.0-or-later
// What tasks and checks share: the surface of exercises 1 to 4, the pressures on it, and the
// cylinders of exercises 4 and 5. This header is part of the handout, so it uses the standard
// library only.
#pragma once

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

#include "assignment/given/numbers.hpp"
#include "assignment/given/student_functions.hpp"
#include "judge/check.hpp"

namespace assignment {

using judge::at;
using judge::Checks;
using judge::greatest;
using judge::joined;
using judge::near;
using judge::Numbers;
using judge::Outcome;
using judge::Program;
using judge::Tally;
using judge::times;

/// Numbers of the pressures that tasks select, over ξ = s/a, which are zero for |ξ| > 1. A number k
/// from fewest_waves to most_waves selects p₀(1 − ξ²)(1 + ½ sin kξ), for which there is no
/// elementary closed form.
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

/// A half-space under a pressure.
struct Surface {
  double young, poisson;           ///< E, ν
  double peak_pressure;            ///< p₀
  double half_width;               ///< a
  double datum;                    ///< the x at which u_z = 0
  double shape = shape::triangle;  ///< the number of the pressure's shape
};

/// The surface of body 1 under the triangle, with the numbers that follow from an id.
inline Surface surface_of(const std::string& id) {
  const OwnNumbers own = own_numbers(id);
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

/// The two cylinders, their load and their grid, with the numbers that follow from an id.
inline Cylinders cylinders_of(const std::string& id) {
  const OwnNumbers own = own_numbers(id);
  return {own.young1,    own.poisson1, own.radius1,
          own.young2,    own.poisson2, own.radius2,
          own.line_load, own.spacing,  static_cast<int>(std::lround(own.nodes)),
          own.datum};
}

/// Computes the answer of a task for the inputs from index `first` on: `compute` gets each input
/// and the answer, to which it appends.
template <class Compute>
Numbers for_each_from(std::size_t first, const Numbers& in, const Compute& compute) {
  Numbers out;
  for (std::size_t i = first; i < in.size(); ++i) compute(in[i], out);
  return out;
}

/// A relative tolerance for rounding errors and for the digits that a sum of logarithms loses near
/// the load.
inline constexpr double roundings = 1e-9;

}  // namespace assignment
