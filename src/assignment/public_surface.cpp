// SPDX-License-Identifier: GPL-3.0-or-later
#include "assignment/public_surface.hpp"

#include <cmath>
#include <cstddef>
#include <string>

#include "assignment/answers.hpp"
#include "assignment/tasks.hpp"

namespace assignment {
namespace {

using course::Numbers;
using course::Outcome;
using course::Program;
using course::Variant;

// Allows for a few roundings and for the digits that a sum of logarithms loses near the load.
constexpr double roundings = 1e-9;

// Eqs. (2) and (3) must agree to this part of the greatest slope, and error estimates may not be
// larger.
constexpr double agreement = 1e-7;
constexpr double most_reported = 1e-6;

Outcome gradient_is_odd(const Program& program, const Variant& variant) {
  const Surface surface = surface_of(variant);
  const double a = surface.half_width;
  const Numbers right = {0.3 * a, 0.9 * a, 1.7 * a, 6 * a};
  const Numbers x = joined(joined(right, times(-1, right)), {0});
  const Numbers g = ask_gradient(program, surface, x);
  const double tolerance = roundings * greatest(g);

  Tally tally("the slope at −x is minus that at x");
  const std::size_t n = right.size();
  for (std::size_t i = 0; i < n; ++i) {
    tally.part(near(g[i], -g[n + i], tolerance), at("x/a", right[i] / a));
  }
  tally.part(near(g.back(), 0, tolerance), at("x/a", 0));
  return tally.outcome();
}

Outcome gradient_falls_as_1_over_x(const Program& program, const Variant& variant) {
  const Surface surface = surface_of(variant);
  const Numbers xi = {20, 100, 1e5, 1e7};
  const Numbers x = times(surface.half_width, xi);
  const Numbers g = ask_gradient(program, surface, joined(x, times(2, x)));

  Tally tally("the surface rises to the right of the load, by half the slope where x doubles");
  const std::size_t n = xi.size();
  for (std::size_t i = 0; i < n; ++i) {
    const double next_term = 1 / (xi[i] * xi[i]);
    const bool halves = near(2 * g[n + i] / g[i], 1, std::fmax(next_term, 10 * roundings));
    tally.part(g[i] < 0 && halves, at("x/a", xi[i]));
  }
  return tally.outcome();
}

// The slopes at two fixed values of x/a.
Numbers two_slopes(const Program& program, const Surface& surface) {
  return ask_gradient(program, surface, {0.4 * surface.half_width, -2.3 * surface.half_width});
}

// Whether the first numbers are `factor` times the second ones.
bool is_multiple(const Numbers& one, const Numbers& other, double factor) {
  const double tolerance = roundings * greatest(one);
  return near(one[0], factor * other[0], tolerance) && near(one[1], factor * other[1], tolerance);
}

Outcome gradient_scales(const Program& program, const Variant& variant) {
  const Surface surface = surface_of(variant);
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
  tally.part(is_multiple(two_slopes(program, wide), g, 1),
             "with the size: at the same x/a it is the same");
  return tally.outcome();
}

const Numbers quadrature_points = {0.15, -0.5, 0.95, 1.05, 3};

Outcome quadrature_agrees(const Program& program, const Variant& variant) {
  const Surface surface = surface_of(variant);
  const Numbers x = times(surface.half_width, quadrature_points);
  const Numbers g = ask_gradient(program, surface, x);
  const Numbers q = ask_quadrature(program, surface, x).value;

  Tally tally("eq. (2) agrees with your eq. (3) to 1e-7 of the greatest slope");
  for (std::size_t i = 0; i < x.size(); ++i) {
    tally.part(near(q[i], g[i], agreement * greatest(g)), at("x/a", quadrature_points[i]));
  }
  return tally.outcome();
}

Outcome quadrature_error_covers(const Program& program, const Variant& variant) {
  const Surface surface = surface_of(variant);
  const Numbers x = times(surface.half_width, quadrature_points);
  const Numbers g = ask_gradient(program, surface, x);
  const Quadratures q = ask_quadrature(program, surface, x);

  Tally tally(
      "the reported error covers the difference from your eq. (3), and is above 0 and at most "
      "1e-6 of the greatest slope");
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double reported = q.abs_error[i];
    const bool says_something = reported > 0 && reported <= most_reported * greatest(g);
    const double of_eq_3 = 1e-12 * greatest(g);
    tally.part(says_something && near(q.value[i], g[i], reported + of_eq_3),
               at("x/a", quadrature_points[i]));
  }
  return tally.outcome();
}

Outcome displacement_keeps_datum(const Program& program, const Variant& variant) {
  const Surface surface = surface_of(variant);
  const double a = surface.half_width;
  const double datum = surface.datum;
  const Numbers u =
      ask_displacement(program, surface, {datum, -datum, 0.6 * a, -0.6 * a, 4 * a, -4 * a});
  const double tolerance = roundings * greatest(u);

  Tally tally("u_z is zero at the datum and the same on both sides");
  tally.part(near(u[0], 0, tolerance), "x = datum");
  tally.part(near(u[1], 0, tolerance), "x = −datum");
  tally.part(near(u[2], u[3], tolerance), "x/a = ±0.6");
  tally.part(near(u[4], u[5], tolerance), "x/a = ±4");
  return tally.outcome();
}

// The derivative of u at the middle of five points h apart (error h⁴/30 times the fifth
// derivative).
double slope_of(const Numbers& u, std::size_t first, double h) {
  return (u[first] - 8 * u[first + 1] + 8 * u[first + 3] - u[first + 4]) / (12 * h);
}

Outcome displacement_has_the_slope(const Program& program, const Variant& variant) {
  const Surface surface = surface_of(variant);
  const double a = surface.half_width;
  const Numbers xi = {0.25, -0.5, 0.7, 1.4, 4};
  const double step =
      0.02;  // a tenth of the distance to the next kink, which gives an error of 1e-5
  Numbers x;
  for (const double middle : xi) {
    for (const int k : {-2, -1, 0, 1, 2}) x.push_back((middle + k * step) * a);
  }
  const Numbers u = ask_displacement(program, surface, x);
  const Numbers g = ask_gradient(program, surface, times(a, xi));

  Tally tally("the difference quotient of u_z is your slope of exercise 1");
  for (std::size_t i = 0; i < xi.size(); ++i) {
    tally.part(near(slope_of(u, 5 * i, step * a), g[i], 1e-4 * greatest(g)), at("x/a", xi[i]));
  }
  return tally.outcome();
}

Outcome displacement_has_the_shape(const Program& program, const Variant& variant) {
  const Surface surface = surface_of(variant);
  const double a = surface.half_width;
  const Numbers u =
      ask_displacement(program, surface, {0, 0.5 * a, a, 3 * a, 50 * a, 100 * a, 200 * a, 400 * a});
  const double fall = u[4] - u[5];

  Tally tally("u_z falls away from the middle, and far away by as much in each doubling of x");
  tally.part(u[0] > u[1] && u[1] > u[2], "from 0 to a");
  tally.part(u[2] > u[3] && u[3] > u[4], "from a to 50 a");
  tally.part(fall > 0 && near(u[5] - u[6], fall, 1e-3 * fall), "from 50 a to 200 a");
  tally.part(fall > 0 && near(u[6] - u[7], fall, 1e-3 * fall), "from 50 a to 400 a");
  return tally.outcome();
}

}  // namespace

course::Checks public_surface_checks() {
  return {{"gradient-odd", gradient_is_odd},
          {"gradient-far", gradient_falls_as_1_over_x},
          {"gradient-scaling", gradient_scales},
          {"quadrature-residual", quadrature_agrees},
          {"quadrature-error", quadrature_error_covers},
          {"displacement-datum", displacement_keeps_datum},
          {"displacement-slope", displacement_has_the_slope},
          {"displacement-shape", displacement_has_the_shape}};
}

}  // namespace assignment
