// SPDX-License-Identifier: GPL-3.0-or-later
// Exercise 3: its task and its public checks. They contain no answers: each tests a property that
// correct numbers have. This header is part of the handout.
#pragma once

#include <cstddef>
#include <string>

#include "assignment/exercises/closed_form_checks.hpp"
#include "assignment/given/bodies.hpp"

namespace assignment::displacement {

inline constexpr const char* task = "displacement";

/// Returns u_z at each x. The inputs are E ν S p₀ a datum x₁ x₂ …, where S is the number of a
/// pressure.
inline Numbers answer(const Numbers& in) {
  const exercise::Load load = load_of(in.at(2), in.at(3), in.at(4));
  return for_each_from(6, in, [&](double x, Numbers& out) {
    out.push_back(exercise::normal_displacement({in[0], in[1]}, load, in[5], x));
  });
}

/// Asks for u_z at each x.
inline Numbers ask(const Program& program, const Surface& s, const Numbers& x) {
  const Numbers inputs =
      joined({s.young, s.poisson, s.shape, s.peak_pressure, s.half_width, s.datum}, x);
  return judge::answer_of(program, task, inputs, x.size());
}

inline Outcome displacement_keeps_datum(const Program& program, const std::string& id) {
  const Surface surface = surface_of(id);
  const double a = surface.half_width;
  const double datum = surface.datum;
  const Numbers u = ask(program, surface, {datum, -datum, 0.6 * a, -0.6 * a, 4 * a, -4 * a});
  const double tolerance = roundings * greatest(u);

  Tally tally("u_z is zero at the datum and the same on both sides");
  tally.part(near(u[0], 0, tolerance), "x = datum");
  tally.part(near(u[1], 0, tolerance), "x = −datum");
  tally.part(near(u[2], u[3], tolerance), "x/a = ±0.6");
  tally.part(near(u[4], u[5], tolerance), "x/a = ±4");
  return tally.outcome();
}

/// The derivative at the middle of five values with spacing h. The error is h⁴/30 times the fifth
/// derivative.
inline double slope_of(const Numbers& u, std::size_t first, double h) {
  return (u[first] - 8 * u[first + 1] + 8 * u[first + 3] - u[first + 4]) / (12 * h);
}

inline Outcome displacement_has_the_slope(const Program& program, const std::string& id) {
  const Surface surface = surface_of(id);
  const double a = surface.half_width;
  const Numbers xi = {0.25, -0.5, 0.7, 1.4, 4};
  // A tenth of the distance to the nearest kink, which gives an error of 1e-5.
  const double step = 0.02;
  Numbers x;
  for (const double middle : xi) {
    for (const int k : {-2, -1, 0, 1, 2}) x.push_back((middle + k * step) * a);
  }
  const Numbers u = ask(program, surface, x);
  const Numbers g = closed_form::ask(program, surface, times(a, xi));

  Tally tally("the difference quotient of u_z is your slope of exercise 1");
  for (std::size_t i = 0; i < xi.size(); ++i) {
    tally.part(near(slope_of(u, 5 * i, step * a), g[i], 1e-4 * greatest(g)), at("x/a", xi[i]));
  }
  return tally.outcome();
}

inline Outcome displacement_has_the_shape(const Program& program, const std::string& id) {
  const Surface surface = surface_of(id);
  const double a = surface.half_width;
  const Numbers u =
      ask(program, surface, {0, 0.5 * a, a, 3 * a, 50 * a, 100 * a, 200 * a, 400 * a});
  const double fall = u[4] - u[5];

  Tally tally(
      "u_z falls with the distance from the middle, far away by the same amount with each "
      "doubling");
  tally.part(u[0] > u[1] && u[1] > u[2], "from 0 to a");
  tally.part(u[2] > u[3] && u[3] > u[4], "from a to 50 a");
  tally.part(fall > 0 && near(u[5] - u[6], fall, 1e-3 * fall), "from 50 a to 200 a");
  tally.part(fall > 0 && near(u[6] - u[7], fall, 1e-3 * fall), "from 50 a to 400 a");
  return tally.outcome();
}

inline Checks public_checks() {
  return {{"displacement-datum", displacement_keeps_datum},
          {"displacement-slope", displacement_has_the_slope},
          {"displacement-shape", displacement_has_the_shape}};
}

}  // namespace assignment::displacement
