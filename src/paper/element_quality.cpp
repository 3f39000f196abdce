// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/element_quality.hpp"

#include <cmath>

#include "line_contact/cylinders.hpp"
#include "line_contact/element_field.hpp"
#include "paper/prelude.hpp"

namespace paper {
namespace {

constexpr double span = 0.9;  // of the half-width

// The means by the midpoint rule with so many points to an element. At the ends of uniform elements
// the slope is infinite like a logarithm, which has an integral; no point lies there.
ElementQuality mean_errors(const ContactCase& c, const Hertz& hertz,
                           const line_contact::Solution& solution, int n_points) {
  const line_contact::McEwen mcewen(hertz);
  const line_contact::Grid& grid = solution.grid;
  const double a = hertz.half_width();
  const double curvature = c.cylinders.relative_curvature();
  double slope_sum = 0, shear_sum = 0;
  long n_sampled = 0;
  for (Eigen::Index i = grid.n_nodes / 2; i + 1 < grid.n_nodes; ++i) {
    for (int k = 0; k < n_points; ++k) {
      const double x = grid.x(i) + (k + 0.5) / n_points * grid.spacing;
      const double z = grid.spacing / 2;
      if (std::abs(x) > span * a) continue;
      const double slope = line_contact::surface_slope(solution, c.cylinders.contact_modulus(), x);
      const double shear = line_contact::stress_beneath(solution, x, z).max_shear();
      slope_sum += std::abs((slope + curvature * x) / (curvature * a));
      shear_sum += std::abs(shear - mcewen.stress(x, z).max_shear()) / hertz.peak_pressure();
      ++n_sampled;
    }
  }
  const auto mean = [&](double sum) { return Estimate{sum / static_cast<double>(n_sampled), 0}; };
  return {mean(slope_sum), mean(shear_sum)};
}

}  // namespace

ElementQuality quality_of(const ContactCase& c, const Hertz& hertz,
                          const line_contact::Solution& solution) {
  constexpr int n_points = 8;
  const ElementQuality first = mean_errors(c, hertz, solution, n_points);
  const ElementQuality second = mean_errors(c, hertz, solution, 2 * n_points);
  const ElementQuality third = mean_errors(c, hertz, solution, 4 * n_points);
  // Beside a logarithm the midpoint rule is wrong in proportion to the distance of its points
  const auto extrapolated = [&](Estimate ElementQuality::*mean) {
    const double before = 2 * (second.*mean).value - (first.*mean).value;
    const double value = 2 * (third.*mean).value - (second.*mean).value;
    return Estimate{value, std::abs(value - before)};
  };
  return {extrapolated(&ElementQuality::slope), extrapolated(&ElementQuality::shear)};
}

}  // namespace paper
