// SPDX-License-Identifier: GPL-3.0-or-later
#include "assignment/hidden_surface.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "assignment/answers.hpp"
#include "assignment/tasks.hpp"
#include "elasticity/load.hpp"
#include "elasticity/material.hpp"
#include "elasticity/surface_quadrature.hpp"
#include "elasticity/triangular_load.hpp"

namespace assignment {
namespace {

using course::Numbers;
using course::Outcome;
using course::Program;
using course::Variant;

// Abscissas in half-widths, under the load, beside it, and near the kinks 0 and ±1.
const Numbers near_the_load = {1e-3, 0.2, -0.5, 0.7071, -0.999, 1, 1.001, -1.5, 4, -15};

// The reference at each x.
Numbers slopes(const Surface& s, const Numbers& x) {
  const elasticity::Material material(s.young, s.poisson);
  const elasticity::TriangularLoad load(s.peak_pressure, s.half_width);
  Numbers found;
  for (const double at : x) found.push_back(elasticity::normal_gradient(material, load, at));
  return found;
}

// The surface's load, whatever its shape.
elasticity::Load load_of(const Surface& s) {
  const auto p = [=](double at) { return pressure(s.shape, s.peak_pressure, s.half_width, at); };
  return elasticity::distributed_load(p, {}, {-s.half_width, 0, s.half_width});
}

elasticity::SurfaceQuadrature quadrature_of(const Surface& s) {
  return {elasticity::Material(s.young, s.poisson), load_of(s), s.datum};
}

// The greatest slope under a load of that shape in units of 2(1−ν²)p₀/(πE), to three digits.
double greatest_slope(const Surface& s) {
  const double unit =
      2 * (1 - s.poisson * s.poisson) * s.peak_pressure / (std::numbers::pi * s.young);
  switch (s.shape) {
    case Shape::triangle:
      return 1.76 * unit;
    case Shape::smooth:
      return 2.14 * unit;
    case Shape::one_sided:
      return 2.76 * unit;
  }
  return 0;
}

// p₀a/E, the unit of the tolerances of displacements.
double unit_displacement(const Surface& surface) {
  return surface.peak_pressure * surface.half_width / surface.young;
}

// A shape of the load, and the abscissas in half-widths at which its surface is tried.
struct Places {
  Shape shape;
  Numbers xi;
};

std::string place(double xi, Shape shape) {
  return at("x/a", xi) + at(", pressure", static_cast<double>(shape));
}

// Compares the slopes at x/a = xi; `tolerance` is absolute.
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

// The triangle has few points, because it has a closed form.
const std::vector<Places> quadrature_places = {
    {Shape::triangle, {1}},
    {Shape::smooth, {1e-3, 0.3, -0.9, 1, -1.8}},
    {Shape::one_sided, {0, -0.6, -0.9999, -1, 1.0001, 5, -40}}};

Outcome quadrature_is_right(const Program& program, const Variant& variant) {
  Surface surface = surface_of(variant);
  Tally tally("the slope by eq. (2) is right to 1e-7 of the greatest");
  for (const auto& [shape, xi] : quadrature_places) {
    surface.shape = shape;
    const Numbers x = times(surface.half_width, xi);
    const Numbers found = ask_quadrature(program, surface, x).value;
    const auto reference = quadrature_of(surface);
    for (std::size_t i = 0; i < x.size(); ++i) {
      tally.part(
          near(found[i], reference.normal_gradient(x[i]).value, 1e-7 * greatest_slope(surface)),
          place(xi[i], shape));
    }
  }
  return tally.outcome();
}

Outcome quadrature_is_honest(const Program& program, const Variant& variant) {
  const std::vector<Places> places = {{Shape::triangle, {0.77}},
                                      {Shape::smooth, {0.05, -0.35, -0.98, 1.02, 2.5}},
                                      {Shape::one_sided, {0.4, -0.7, 0.98, -1.02, -1.3, -12}}};
  Surface surface = surface_of(variant);
  Tally tally(
      "the truth is within the reported error, which is at most 1e-6 of the greatest slope");
  for (const auto& [shape, xi] : places) {
    surface.shape = shape;
    const Numbers x = times(surface.half_width, xi);
    const Quadratures q = ask_quadrature(program, surface, x);
    const auto reference = quadrature_of(surface);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double reported = q.abs_error[i];
      const bool says_something = reported > 0 && reported <= 1e-6 * greatest_slope(surface);
      const auto truth = reference.normal_gradient(x[i]);
      const double margin = reported + truth.abs_error;
      tally.part(says_something && near(q.value[i], truth.value, margin), place(xi[i], shape));
    }
  }
  return tally.outcome();
}

// Counts at how many of these places u_z is right, with the surface's datum.
void try_displacement(const Program& program, Surface surface, const Places& places, Tally& tally) {
  surface.shape = places.shape;
  const Numbers x = times(surface.half_width, places.xi);
  const Numbers found = ask_displacement(program, surface, x);
  const auto reference = quadrature_of(surface);
  for (std::size_t i = 0; i < x.size(); ++i) {
    tally.part(near(found[i], reference.normal_displacement(x[i]).value,
                    1e-8 * unit_displacement(surface)),
               place(places.xi[i], places.shape));
  }
}

Outcome displacement_is_right(const Program& program, const Variant& variant) {
  Tally tally("u_z is right to 1e-8 of p0 a/E");
  for (const Places& places :
       {Places{Shape::triangle, {0.7}}, Places{Shape::smooth, {0, -0.3, 0.999, 1.2, 20}},
        Places{Shape::one_sided, {0.001, 0.7, -0.99, 1, -3, -200}}}) {
    try_displacement(program, surface_of(variant), places, tally);
  }
  return tally.outcome();
}

Outcome displacement_is_right_elsewhere(const Program& program, const Variant& variant) {
  Surface surface{variant("young2"), variant("poisson2"), 0.37 * variant("peak_pressure"),
                  2.3 * variant("half_width"), 0};
  Tally tally("u_z is right to 1e-8 of p0 a/E for another material, another size and datum");
  for (const double datum : {0.45, 1.0, -2.5, 60.0}) {
    surface.datum = datum * surface.half_width;
    Tally of_datum("");
    try_displacement(program, surface, {Shape::one_sided, {0.1, -0.6, 1.1, 7}}, of_datum);
    tally.part(of_datum.outcome().share == 1, at("datum/a", datum));
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
