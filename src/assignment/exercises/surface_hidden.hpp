// SPDX-License-Identifier: GPL-3.0-or-later
// What the hidden checks of exercises 2 and 3 share: the reference for loads of any shape.
#pragma once

#include <string>

#include "assignment/given/answers.hpp"
#include "assignment/given/bodies.hpp"
#include "course/assignment/variant.hpp"
#include "elasticity/load.hpp"
#include "elasticity/material.hpp"
#include "elasticity/surface_quadrature.hpp"

namespace assignment {

/// The surface's load, whatever its shape.
inline elasticity::Load elastic_load(const Surface& s) {
  const auto p = [=](double at) { return pressure(s.shape, s.peak_pressure, s.half_width, at); };
  return elasticity::distributed_load(p, {-s.half_width, 0, s.half_width});
}

inline elasticity::SurfaceQuadrature reference_of(const Surface& s) {
  return {elasticity::Material(s.young, s.poisson), elastic_load(s), s.datum};
}

/// A shape of the load by its number, and the abscissas in half-widths at which its surface is
/// tried.
struct Places {
  double shape;
  course::Numbers xi;
};

/// Waves whose number no handout names, so that whoever remembers the other shapes does not know
/// this one.
inline double waves(const course::Variant& variant) {
  return 4 + 12 * variant("poisson2");
}

inline std::string place(double xi, double shape) {
  return at("x/a", xi) + (shape < shape::fewest_waves ? at(", pressure", shape) : ", waves");
}

}  // namespace assignment
