// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/element_quality.hpp"

#include <algorithm>
#include <cmath>

#include "contact/element_field.hpp"
#include "contact/mcewen.hpp"

namespace paper {
ElementQuality quality_of(const parameters::ContactCase& c, const contact::Hertz& hertz,
                          const contact::Solution& solution) {
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
      const double slope = contact::surface_slope(solution, c.cylinders.contact_modulus(), x);
      const double shear = contact::stress_beneath(solution, x, z).max_shear();
      const double slope_error = (slope + curvature * x) / (curvature * a);
      const double shear_error = shear - mcewen.stress(x, z).max_shear();
      worst.slope = std::max(worst.slope, std::abs(slope_error));
      worst.shear = std::max(worst.shear, std::abs(shear_error) / hertz.peak_pressure());
    }
  }
  return worst;
}

}  // namespace paper
