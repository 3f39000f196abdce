// SPDX-License-Identifier: GPL-3.0-or-later
// Exercise 2: its task and its public checks. They contain no answers: each tests a property that
// correct numbers have. This header is part of the handout.
#pragma once

#include <cstddef>
#include <string>

#include "assignment/exercises/closed_form_checks.hpp"
#include "assignment/given/bodies.hpp"

namespace assignment::quadrature {

/// Eqs. (2) and (3) must agree to this fraction of the greatest slope.
inline constexpr double agreement = 1e-7;

/// Error estimates must not exceed this fraction of the greatest slope.
inline constexpr double most_reported = 1e-6;

/// The abscissas x/a of the public checks.
inline const Numbers points = {0.15, -0.5, 0.95, 1.05, 3};

inline constexpr const char* task = "gradient_by_quadrature";

/// Returns value and abs_error at each x, eq. (2). The inputs are E ν S p₀ a x₁ x₂ …, where S is
/// the number of a pressure.
inline Numbers answer(const Numbers& in) {
  const exercise::Load load = load_of(in.at(2), in.at(3), in.at(4));
  return for_each_from(5, in, [&](double x, Numbers& out) {
    const auto found = exercise::normal_gradient_by_quadrature({in[0], in[1]}, load, x);
    out.push_back(found.value);
    out.push_back(found.abs_error);
  });
}

/// The program's answer: ∂u_z/∂x by eq. (2) at each x, and its error bound.
struct Answer {
  Numbers value;
  Numbers abs_error;
};

inline Answer ask(const Program& program, const Surface& s, const Numbers& x) {
  const Numbers inputs = joined({s.young, s.poisson, s.shape, s.peak_pressure, s.half_width}, x);
  const Numbers pairs = judge::answer_of(program, task, inputs, 2 * x.size());
  Answer found;
  for (std::size_t i = 0; i < pairs.size(); i += 2) {
    found.value.push_back(pairs[i]);
    found.abs_error.push_back(pairs[i + 1]);
  }
  return found;
}

inline Outcome quadrature_agrees(const Program& program, const std::string& id) {
  const Surface surface = surface_of(id);
  const Numbers x = times(surface.half_width, points);
  const Numbers g = closed_form::ask(program, surface, x);
  const Numbers q = ask(program, surface, x).value;

  Tally tally("eq. (2) agrees with your eq. (3) to 1e-7 of the greatest slope");
  for (std::size_t i = 0; i < x.size(); ++i) {
    tally.part(near(q[i], g[i], agreement * greatest(g)), at("x/a", points[i]));
  }
  return tally.outcome();
}

inline Outcome quadrature_error_covers(const Program& program, const std::string& id) {
  const Surface surface = surface_of(id);
  const Numbers x = times(surface.half_width, points);
  const Numbers g = closed_form::ask(program, surface, x);
  const Answer q = ask(program, surface, x);

  Tally tally(
      "the reported error covers the difference from your eq. (3), is greater than 0, and is at "
      "most "
      "1e-6 of the greatest slope");
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double reported = q.abs_error[i];
    const bool is_plausible = reported > 0 && reported <= most_reported * greatest(g);
    const double of_eq_3 = 1e-12 * greatest(g);
    tally.part(is_plausible && near(q.value[i], g[i], reported + of_eq_3), at("x/a", points[i]));
  }
  return tally.outcome();
}

inline Checks public_checks() {
  return {{"quadrature-residual", quadrature_agrees},
          {"quadrature-error", quadrature_error_covers}};
}

}  // namespace assignment::quadrature
