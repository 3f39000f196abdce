// SPDX-License-Identifier: GPL-3.0-or-later
// Exercise 1: its task and its public checks. They contain no answers: each tests a property that
// correct numbers have. This header is part of the handout.
#pragma once

#include <cmath>
#include <cstddef>
#include <string>

#include "assignment/given/bodies.hpp"

namespace assignment::closed_form {

inline constexpr const char* task = "gradient";

/// Returns ∂u_z/∂x at each x, eq. (3). The inputs are E ν p₀ a x₁ x₂ …
inline Numbers answer(const Numbers& in) {
  return for_each_from(4, in, [&](double x, Numbers& out) {
    out.push_back(exercise::normal_gradient({in[0], in[1]}, {in[2], in[3]}, x));
  });
}

/// Asks for ∂u_z/∂x at each x under the triangle of eq. (3), whatever the surface's shape.
inline Numbers ask(const Program& program, const Surface& s, const Numbers& x) {
  const Numbers inputs = joined({s.young, s.poisson, s.peak_pressure, s.half_width}, x);
  return judge::answer_of(program, task, inputs, x.size());
}

inline Outcome gradient_is_odd(const Program& program, const std::string& id) {
  const Surface surface = surface_of(id);
  const double a = surface.half_width;
  const Numbers right = {0.3 * a, 0.9 * a, 1.7 * a, 6 * a};
  const Numbers x = joined(joined(right, times(-1, right)), {0});
  const Numbers g = ask(program, surface, x);
  const double tolerance = roundings * greatest(g);

  Tally tally("the slope at −x is minus that at x");
  const std::size_t n = right.size();
  for (std::size_t i = 0; i < n; ++i) {
    tally.part(near(g[i], -g[n + i], tolerance), at("x/a", right[i] / a));
  }
  tally.part(near(g.back(), 0, tolerance), at("x/a", 0));
  return tally.outcome();
}

inline Outcome gradient_falls_as_1_over_x(const Program& program, const std::string& id) {
  const Surface surface = surface_of(id);
  const Numbers xi = {20, 100, 1e5, 1e7};
  const Numbers x = times(surface.half_width, xi);
  const Numbers g = ask(program, surface, joined(x, times(2, x)));

  Tally tally("the slope is negative to the right of the load, and halves when x doubles");
  const std::size_t n = xi.size();
  for (std::size_t i = 0; i < n; ++i) {
    const double next_term = 1 / (xi[i] * xi[i]);
    const bool halves = near(2 * g[n + i] / g[i], 1, std::fmax(next_term, 10 * roundings));
    tally.part(g[i] < 0 && halves, at("x/a", xi[i]));
  }
  return tally.outcome();
}

/// The slopes at two fixed values of x/a.
inline Numbers two_slopes(const Program& program, const Surface& surface) {
  return ask(program, surface, {0.4 * surface.half_width, -2.3 * surface.half_width});
}

/// Whether the two numbers in `one` are `factor` times those in `other`.
inline bool is_multiple(const Numbers& one, const Numbers& other, double factor) {
  const double tolerance = roundings * greatest(one);
  return near(one[0], factor * other[0], tolerance) && near(one[1], factor * other[1], tolerance);
}

inline Outcome gradient_scales(const Program& program, const std::string& id) {
  const Surface surface = surface_of(id);
  Surface pressed = surface;
  pressed.peak_pressure *= 3;
  Surface stiff = surface;
  stiff.young *= 2;
  Surface uncoupled = surface;
  uncoupled.poisson = 0;
  Surface wide = surface;
  wide.half_width *= 5;

  const Numbers g = two_slopes(program, surface);
  const double nu = surface.poisson;
  Tally tally("the slope scales");
  tally.part(is_multiple(two_slopes(program, pressed), g, 3), "with the pressure");
  tally.part(is_multiple(two_slopes(program, stiff), g, 0.5), "with 1/E");
  tally.part(is_multiple(g, two_slopes(program, uncoupled), 1 - nu * nu), "with Poisson's ratio");
  tally.part(is_multiple(two_slopes(program, wide), g, 1), "with the size: it depends on x/a only");
  return tally.outcome();
}

inline Checks public_checks() {
  return {{"gradient-odd", gradient_is_odd},
          {"gradient-far", gradient_falls_as_1_over_x},
          {"gradient-scaling", gradient_scales}};
}

}  // namespace assignment::closed_form
