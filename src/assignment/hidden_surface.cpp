// SPDX-License-Identifier: GPL-3.0-or-later
#include "assignment/hidden_surface.hpp"

#include <cmath>
#include <cstddef>

#include "assignment/answers.hpp"
#include "assignment/tasks.hpp"
#include "elasticity/material.hpp"
#include "elasticity/triangular_load.hpp"

namespace assignment {
namespace {

using course::Numbers;
using course::Outcome;
using course::Program;
using course::Variant;

// Near the kinks 0 and ±1, under the load and beside it; in half-widths.
const Numbers near_the_load = {1e-3, 0.2, -0.5, 0.7071, -0.999, 1, 1.001, -1.5, 4, -15};

// The reference at each x.
Numbers slopes(const Surface& s, const Numbers& x) {
  const elasticity::Material material(s.young, s.poisson);
  const elasticity::TriangularLoad load(s.peak_pressure, s.half_width);
  Numbers found;
  for (const double at : x) found.push_back(elasticity::normal_gradient(material, load, at));
  return found;
}

Numbers displacements(const Surface& s, const Numbers& x) {
  const elasticity::Material material(s.young, s.poisson);
  const elasticity::TriangularLoad load(s.peak_pressure, s.half_width);
  Numbers found;
  for (const double at : x) {
    found.push_back(elasticity::normal_displacement(material, load, at, s.datum));
  }
  return found;
}

// Compares at x/a = xi; `tolerance` is absolute.
Outcome compare(const char* property, const Numbers& xi, const Numbers& found,
                const Numbers& reference, double tolerance) {
  Tally tally(property);
  for (std::size_t i = 0; i < xi.size(); ++i) {
    tally.part(near(found[i], reference[i], tolerance), at("x/a", xi[i]));
  }
  return tally.outcome();
}

Outcome gradient_is_right(const Program& program, const Variant& variant) {
  const Surface surface = surface_of(variant);
  const Numbers x = times(surface.half_width, near_the_load);
  const Numbers reference = slopes(surface, x);
  return compare("the slope is right to 1e-9 of the greatest", near_the_load,
                 ask_gradient(program, surface, x), reference, 1e-9 * greatest(reference));
}

Outcome gradient_keeps_digits(const Program& program, const Variant& variant) {
  const Surface surface = surface_of(variant);
  const Numbers xi = {1e2, -1e4, 1e6, -1e8};
  const Numbers x = times(surface.half_width, xi);
  const Numbers found = ask_gradient(program, surface, x);
  const Numbers reference = slopes(surface, x);
  Tally tally("the slope is right to eight digits");
  for (std::size_t i = 0; i < x.size(); ++i) {
    tally.part(near(found[i], reference[i], 1e-8 * std::abs(reference[i])), at("x/a", xi[i]));
  }
  return tally.outcome();
}

Outcome quadrature_is_right(const Program& program, const Variant& variant) {
  const Surface surface = surface_of(variant);
  const Numbers xi = {1e-3, 0.3, -0.6, 0.9, -0.9999, 1, 1.0001, -1.8, 5, -40};
  const Numbers x = times(surface.half_width, xi);
  const Numbers reference = slopes(surface, x);
  return compare("the slope by eq. (2) is right to 1e-7 of the greatest", xi,
                 ask_quadrature(program, surface, x).value, reference, 1e-7 * greatest(reference));
}

Outcome quadrature_is_honest(const Program& program, const Variant& variant) {
  const Surface surface = surface_of(variant);
  const Numbers xi = {0.05, -0.35, 0.77, -0.98, 1.02, -1.3, 2.5, -12};
  const Numbers x = times(surface.half_width, xi);
  const Numbers reference = slopes(surface, x);
  const Quadratures q = ask_quadrature(program, surface, x);
  const double greatest_slope = greatest(reference);

  Tally tally(
      "the truth is within the reported error, which is at most 1e-6 of the greatest slope");
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double reported = q.abs_error[i];
    const bool says_something = reported > 0 && reported <= 1e-6 * greatest_slope;
    const double of_reference = 1e-13 * greatest_slope;
    tally.part(says_something && near(q.value[i], reference[i], reported + of_reference),
               at("x/a", xi[i]));
  }
  return tally.outcome();
}

// p₀a/E, what displacements are measured with.
double unit_displacement(const Surface& surface) {
  return surface.peak_pressure * surface.half_width / surface.young;
}

Outcome displacement_is_right(const Program& program, const Variant& variant) {
  const Surface surface = surface_of(variant);
  const Numbers xi = {0, 0.001, -0.3, 0.7, -0.99, 1, 1.2, -3, 20, -200};
  const Numbers x = times(surface.half_width, xi);
  return compare("u_z is right to 1e-8 of p0 a/E", xi, ask_displacement(program, surface, x),
                 displacements(surface, x), 1e-8 * unit_displacement(surface));
}

Outcome displacement_is_right_elsewhere(const Program& program, const Variant& variant) {
  Surface surface{variant("young2"), variant("poisson2"), 0.37 * variant("peak_pressure"),
                  2.3 * variant("half_width"), 0};
  const Numbers xi = {0.1, -0.6, 1.1, 7};
  const Numbers x = times(surface.half_width, xi);
  Tally tally("u_z is right to 1e-8 of p0 a/E for another material and load");
  for (const double datum : {0.45, 1.0, -2.5, 60.0}) {
    surface.datum = datum * surface.half_width;
    const Numbers found = ask_displacement(program, surface, x);
    const Numbers reference = displacements(surface, x);
    bool all = true;
    for (std::size_t i = 0; i < x.size(); ++i) {
      all = all && near(found[i], reference[i], 1e-8 * unit_displacement(surface));
    }
    tally.part(all, at("datum/a", datum));
  }
  return tally.outcome();
}

}  // namespace

course::Checks hidden_surface_checks() {
  return {{"gradient-reference", gradient_is_right},
          {"gradient-far-digits", gradient_keeps_digits},
          {"quadrature-reference", quadrature_is_right},
          {"quadrature-honest", quadrature_is_honest},
          {"displacement-reference", displacement_is_right},
          {"displacement-other", displacement_is_right_elsewhere}};
}

}  // namespace assignment
