// SPDX-License-Identifier: GPL-3.0-or-later
// Exercise 5: its task and its public checks. They contain no answers: each tests a property that
// correct numbers have. This header is part of the handout.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>

#include "assignment/exercises/influence_checks.hpp"
#include "assignment/given/bodies.hpp"

namespace assignment::contact_solver {

inline constexpr const char* task = "contact";

/// Returns δ, a and the n pressures. The inputs are E₁ ν₁ R₁ E₂ ν₂ R₂ P c n datum.
inline Numbers answer(const Numbers& in) {
  const exercise::Cylinders cylinders{
      {in.at(0), in.at(1)}, in.at(2), {in.at(3), in.at(4)}, in.at(5)};
  const exercise::Grid grid{static_cast<int>(std::lround(in.at(8))), in.at(7)};
  const auto found = exercise::solve_contact(cylinders, grid, in.at(9), in.at(6));
  return joined({found.approach, found.half_width}, found.pressure);
}

/// The program's answer: the approach δ, the half-width a, and the pressure at each node.
struct Answer {
  double approach;
  double half_width;
  Numbers pressure;
};

/// The inputs of the task for these cylinders.
inline Numbers inputs_of(const Cylinders& c) {
  return {c.young1,    c.poisson1, c.radius1,
          c.young2,    c.poisson2, c.radius2,
          c.line_load, c.spacing,  static_cast<double>(c.n_nodes),
          c.datum};
}

inline Answer ask(const Program& program, const Cylinders& c) {
  const std::size_t n_before_pressures = 2;
  const Numbers numbers = judge::answer_of(
      program, task, inputs_of(c), n_before_pressures + static_cast<std::size_t>(c.n_nodes));
  return {
      numbers[0], numbers[1],
      Numbers(numbers.begin() + static_cast<std::ptrdiff_t>(n_before_pressures), numbers.end())};
}

/// Computes the gap u_z1 + u_z2 + h − δ at each node, eqs. (1a) and (1b), with the coefficients of
/// the student's program; NaN where a coefficient is NaN.
inline Numbers gaps(const Program& program, const Cylinders& c, const Answer& contact) {
  Numbers k(static_cast<std::size_t>(c.n_nodes));
  std::iota(k.begin(), k.end(), 0);
  const Numbers coefficients = influence::ask(program, c.contact_modulus(), c.spacing, c.datum, k);
  Numbers gap;
  for (int i = 0; i < c.n_nodes; ++i) {
    double sum = c.relative_curvature() * c.x(i) * c.x(i) / 2 - contact.approach;
    for (int j = 0; j < c.n_nodes; ++j) {
      sum += coefficients[static_cast<std::size_t>(std::abs(i - j))] *
             contact.pressure[static_cast<std::size_t>(j)];
    }
    gap.push_back(sum);
  }
  return gap;
}

inline constexpr double pressure_roundings = 1e-8;

/// The same cylinders under a fraction of the load.
inline Cylinders with_load(Cylinders cylinders, double share) {
  cylinders.line_load *= share;
  return cylinders;
}

inline Outcome contact_carries_the_load(const Program& program, const std::string& id) {
  Tally tally("the sum of the pressures times the spacing is the load");
  for (const double share : {1., 0.6}) {
    const Cylinders c = with_load(cylinders_of(id), share);
    const Numbers p = ask(program, c).pressure;
    const double carried = c.spacing * std::accumulate(p.begin(), p.end(), 0.0);
    tally.part(near(carried, c.line_load, pressure_roundings * c.line_load),
               at("fraction of your load", share));
  }
  return tally.outcome();
}

inline Outcome contact_pressure_has_the_shape(const Program& program, const std::string& id) {
  const Numbers p = ask(program, cylinders_of(id)).pressure;
  const double top = greatest(p);
  const std::size_t n = p.size();
  bool is_symmetric = top > 0;
  for (std::size_t i = 0; i < n; ++i) {
    is_symmetric = is_symmetric && near(p[i], p[n - 1 - i], pressure_roundings * top);
  }

  Tally tally("the pressure");
  tally.part(top > 0 && std::all_of(p.begin(), p.end(), [](double at) { return at >= 0; }),
             "is nowhere negative");
  tally.part(is_symmetric, "is symmetric");
  tally.part(top > 0 && near(p[n / 2], top, pressure_roundings * top), "is greatest in the middle");
  tally.part(top > 0 && p.front() == 0 && p.back() == 0, "is zero at the ends of the grid");
  return tally.outcome();
}

inline Outcome contact_closes_the_gap(const Program& program, const std::string& id) {
  Tally tally("the gap u_z1 + u_z2 + h − δ");
  for (const double share : {1., 0.6}) {
    const Cylinders c = with_load(cylinders_of(id), share);
    const Answer contact = ask(program, c);
    const Numbers gap = gaps(program, c, contact);
    const double edge = c.x(c.n_nodes - 1);
    const double tolerance = 1e-6 * c.relative_curvature() * edge * edge / 2;
    bool is_closed = greatest(contact.pressure) > 0;
    bool is_open = is_closed;
    for (std::size_t i = 0; i < gap.size(); ++i) {
      if (contact.pressure[i] != 0) is_closed = is_closed && near(gap[i], 0, tolerance);
      if (contact.pressure[i] == 0) is_open = is_open && gap[i] >= -tolerance;
    }
    tally.part(is_closed, at("is zero where there is pressure, with load / (your load)", share));
    tally.part(is_open, at("is not negative elsewhere, with load / (your load)", share));
  }
  return tally.outcome();
}

/// Whether the lists agree within `tolerance` times the greatest number of `b`.
inline bool same(const Numbers& a, const Numbers& b, double tolerance) {
  bool all = true;
  for (std::size_t i = 0; i < a.size(); ++i) {
    all = all && near(a[i], b[i], tolerance * greatest(b));
  }
  return all;
}

inline Outcome contact_scales(const Program& program, const std::string& id) {
  constexpr double tolerance = 100 * pressure_roundings;
  const Cylinders c = cylinders_of(id);
  Cylinders large = with_load(c, 4);
  large.spacing *= 2;
  large.datum *= 2;
  Cylinders stiff = with_load(c, 3);
  stiff.young1 *= 3;
  stiff.young2 *= 3;
  const Answer one = ask(program, c);
  const Answer two = ask(program, large);
  const Answer three = ask(program, stiff);
  const double a = one.half_width;

  Tally tally("spacing and datum doubled, load quadrupled (1); modulus and load tripled (2)");
  tally.part(same(times(2, one.pressure), two.pressure, tolerance), "(1) doubles the pressure");
  tally.part(a > 0 && near(2 * a, two.half_width, tolerance * a), "(1) doubles the half-width");
  tally.part(same(times(3, one.pressure), three.pressure, tolerance), "(2) triples the pressure");
  tally.part(a > 0 && near(a, three.half_width, tolerance * a),
             "(2) does not change the half-width");
  return tally.outcome();
}

/// Asks for the half-width on a grid whose spacing is a/(spacings + 3/8). The fraction 3/8 is
/// always the same, because the error depends on where the contact ends between two nodes.
inline double half_width_on(const Program& program, Cylinders c, double a, int spacings) {
  c.spacing = a / (spacings + 0.375);
  c.n_nodes = 2 * static_cast<int>(1.3 * spacings) + 1;
  return ask(program, c).half_width;
}

inline Outcome contact_half_width_converges(const Program& program, const std::string& id) {
  const Cylinders c = cylinders_of(id);
  const double a = ask(program, c).half_width;
  if (!(a > 0)) return {0, "the half-width is not positive"};
  Tally tally(
      "each halving of the spacing changes the half-width by a quarter of the previous change");
  for (const int spacings : {8, 12}) {
    const double coarse = half_width_on(program, c, a, spacings);
    const double middle = half_width_on(program, c, a, 2 * spacings);
    const double fine = half_width_on(program, c, a, 4 * spacings);
    const double ratio = (coarse - middle) / (middle - fine);
    tally.part(ratio > 3 && ratio < 5, at("initial number of spacings per half-width", spacings));
  }
  return tally.outcome();
}

inline Checks public_checks() {
  return {{"contact-load", contact_carries_the_load},
          {"contact-pressure", contact_pressure_has_the_shape},
          {"contact-gap", contact_closes_the_gap},
          {"contact-scaling", contact_scales},
          {"contact-convergence", contact_half_width_converges}};
}

}  // namespace assignment::contact_solver
