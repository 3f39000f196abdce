// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/element_field.hpp"

#include "elasticity/concentrated_load.hpp"
#include "elasticity/interior_stress.hpp"
#include "elasticity/load_shapes.hpp"

namespace line_contact {
namespace {

using elasticity::Stress;

// Returns the slope of both bodies together at the distance x from an element of pressure p.
double slope_of(const elasticity::Material& both, Element element, double p, double c, double x) {
  switch (element) {
    case Element::triangular:
      return elasticity::normal_gradient(both, elasticity::TriangularLoad(p, c), x);
    case Element::uniform:
      return elasticity::normal_gradient(both, elasticity::UniformLoad(p, c / 2), x);
    case Element::point:
      break;
  }
  return elasticity::normal_gradient(both, elasticity::ConcentratedLoad(c * p), x);
}

Stress stress_of(Element element, double p, double c, double x, double z) {
  switch (element) {
    case Element::triangular:
      return stress_under(elasticity::TriangularLoad(p, c), x, z);
    case Element::uniform:
      return stress_under(elasticity::LinearSegment{-c / 2, c / 2, p, p}, x, z);
    case Element::point:
      break;
  }
  return stress_under(elasticity::ConcentratedLoad(c * p), x, z);
}

}  // namespace

double surface_slope(const Solution& solution, double contact_modulus, double x) {
  const elasticity::Material both(contact_modulus,
                                  0);  // with ν = 0 and E* in the place of E, the factor
                                       // 2(1−ν²)/(πE) is the sum of both bodies'
  const Grid& grid = solution.grid;
  double slope = 0;
  for (Eigen::Index j = 0; j < grid.n_nodes; ++j) {
    const double p = solution.pressure[j];
    if (p != 0) slope += slope_of(both, solution.element, p, grid.spacing, x - grid.x(j));
  }
  return slope;
}

Stress stress_beneath(const Solution& solution, double x, double z) {
  const Grid& grid = solution.grid;
  Stress stress;
  for (Eigen::Index j = 0; j < grid.n_nodes; ++j) {
    const double p = solution.pressure[j];
    if (p != 0) stress += stress_of(solution.element, p, grid.spacing, x - grid.x(j), z);
  }
  return stress;
}

}  // namespace line_contact
