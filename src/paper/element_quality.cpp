// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/element_quality.hpp"

#include <algorithm>
#include <cmath>

#include "contact/mcewen.hpp"
#include "elasticity/concentrated_load.hpp"
#include "elasticity/interior_stress.hpp"
#include "elasticity/uniform_load.hpp"

namespace paper {
namespace {

using contact::Element;
using elasticity::Stress;

// The slope a distance x from an element of pressure p, of both bodies together.
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

// The stress at (x, z) from the same; of a force Flamant's (Johnson 2.23).
Stress stress_of(Element element, double p, double c, double x, double z) {
  switch (element) {
    case Element::triangular:
      return stress_under(elasticity::TriangularLoad(p, c), x, z);
    case Element::uniform:
      return stress_under(elasticity::LinearSegment{-c / 2, c / 2, p, p}, x, z);
    case Element::point:
      break;
  }
  const double square = x * x + z * z;
  const double factor = -2 * c * p / (std::acos(-1.0) * square * square);
  return {factor * x * x * z, factor * z * z * z, factor * x * z * z};
}

}  // namespace

ElementQuality quality_of(const parameters::ContactCase& c, const contact::Hertz& hertz,
                          const contact::Solution& solution) {
  const elasticity::Material both(c.cylinders.contact_modulus(), 0);  // 2(1−0)/(πE*)
  const contact::McEwen mcewen(hertz);
  const contact::Grid& grid = solution.grid;
  const double a = hertz.half_width();
  const double curvature = c.cylinders.relative_curvature();
  ElementQuality worst{};
  for (Eigen::Index i = 0; i + 1 < grid.n_nodes; ++i) {
    for (const double share : {0.125, 0.375, 0.625, 0.875}) {
      const double x = grid.x(i) + share * grid.spacing;
      const double z = grid.spacing / 2;
      if (std::abs(x) > 0.9 * a) continue;
      double slope = 0;
      Stress stress;
      for (Eigen::Index j = 0; j < grid.n_nodes; ++j) {
        const double p = solution.pressure[j];
        if (p == 0) continue;
        slope += slope_of(both, solution.element, p, grid.spacing, x - grid.x(j));
        stress += stress_of(solution.element, p, grid.spacing, x - grid.x(j), z);
      }
      const double slope_error = (slope + curvature * x) / (curvature * a);
      const double shear_error = stress.max_shear() - mcewen.stress(x, z).max_shear();
      worst.slope = std::max(worst.slope, std::abs(slope_error));
      worst.shear = std::max(worst.shear, std::abs(shear_error) / hertz.peak_pressure());
    }
  }
  return worst;
}

}  // namespace paper
