// SPDX-License-Identifier: GPL-3.0-or-later
#include "assignment/hidden/reference.hpp"

#include <cmath>
#include <numbers>

#include "elasticity/loads.hpp"
#include "elasticity/material.hpp"
#include "elasticity/surface_quadrature.hpp"
#include "line_contact/cylinders.hpp"
#include "line_contact/element.hpp"
#include "line_contact/methods.hpp"

namespace assignment {
namespace {

elasticity::SurfaceQuadrature surface_under_load(const Surface& s) {
  const auto p = [=](double at) { return pressure(s.shape, s.peak_pressure, s.half_width, at); };
  const elasticity::Load load = elasticity::distributed_load(p, {-s.half_width, 0, s.half_width});
  return {elasticity::Material(s.young, s.poisson), load, s.datum};
}

double unit_coefficient(double k) {
  return line_contact::influence_coefficient(line_contact::Element::triangular, k);
}

}  // namespace

Numbers slopes_in_closed_form(const Surface& s, const Numbers& x) {
  const elasticity::Material material(s.young, s.poisson);
  const elasticity::TriangularLoad load(s.peak_pressure, s.half_width);
  Numbers found;
  for (const double at : x) found.push_back(elasticity::normal_gradient(material, load, at));
  return found;
}

std::vector<exercise::Estimate> slopes(const Surface& surface, const Numbers& x) {
  const elasticity::SurfaceQuadrature loaded = surface_under_load(surface);
  std::vector<exercise::Estimate> found;
  for (const double at : x) {
    const auto slope = loaded.normal_gradient(at);
    found.push_back({slope.value, slope.abs_error});
  }
  return found;
}

Numbers displacements(const Surface& surface, const Numbers& x) {
  const elasticity::SurfaceQuadrature loaded = surface_under_load(surface);
  Numbers found;
  for (const double at : x) found.push_back(loaded.normal_displacement(at).value);
  return found;
}

double influence_coefficient(double contact_modulus, double spacing, double datum, double k) {
  return -2 * spacing / (std::numbers::pi * contact_modulus) *
         (unit_coefficient(k) - unit_coefficient(datum / spacing));
}

ContactOfCylinders contact_of(const Cylinders& c) {
  using line_contact::Radius;
  const line_contact::CylinderPair pair(
      {c.young1, c.poisson1}, Radius::of_cylinder("radius1", c.radius1), {c.young2, c.poisson2},
      Radius::of_cylinder("radius2", c.radius2));
  const line_contact::Solution solution = line_contact::solve_by_matrix_inversion(
      {pair.profile(), pair.contact_modulus(), {c.n_nodes, c.spacing}}, c.line_load);
  // At the greatest pressure the surfaces touch, so the approach is the initial gap plus the
  // displacement there.
  Eigen::Index touching = 0;
  solution.pressure.maxCoeff(&touching);
  double approach = pair.profile().gap(solution.grid.x(touching));
  for (Eigen::Index i = 0; i < solution.pressure.size(); ++i) {
    const auto k = static_cast<double>(std::abs(i - touching));
    approach +=
        influence_coefficient(pair.contact_modulus(), c.spacing, c.datum, k) * solution.pressure[i];
  }
  return {approach, solution.half_width(),
          Numbers(solution.pressure.begin(), solution.pressure.end())};
}

}  // namespace assignment
