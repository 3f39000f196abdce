// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/convergence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "elasticity/stress_beneath.hpp"
#include "line_contact/cylinders.hpp"
#include "line_contact/dense_methods.hpp"
#include "line_contact/solver.hpp"
#include "paper/bounds.hpp"
#include "paper/prelude.hpp"

namespace paper {
namespace {

constexpr double span = 0.9;  // of the half-width

// The stress beneath the elements of any kind; under forces it is Flamant's (Johnson 2.23).
elasticity::Stress stress_of_elements(const line_contact::Solution& solution, double x, double z) {
  using line_contact::Element;
  if (solution.element == Element::triangular) return stress_beneath(solution, x, z);
  const double c = solution.grid.spacing;
  elasticity::Stress sum;
  for (Eigen::Index j = 0; j < solution.grid.n_nodes; ++j) {
    const double p = solution.pressure[j];
    if (p == 0) continue;
    const double t = x - solution.grid.x(j);
    if (solution.element == Element::uniform) {
      sum += elasticity::stress_beneath(std::array{-c / 2, c / 2}, std::array{p, p}, t, z);
    } else {
      const double factor = -2 * c * p * z / (std::numbers::pi * std::pow(t * t + z * z, 2));
      sum += {factor * t * t, factor * z * z, factor * t * z};
    }
  }
  return sum;
}

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
      const double slope = line_contact::surface_slope(solution, x);
      const double shear = stress_of_elements(solution, x, z).max_shear();
      slope_sum += std::abs((slope + curvature * x) / (curvature * a));
      shear_sum += std::abs(shear - mcewen.stress(x, z).max_shear()) / hertz.peak_pressure();
      ++n_sampled;
    }
  }
  const auto mean = [&](double sum) { return Estimate{sum / static_cast<double>(n_sampled), 0}; };
  return {mean(slope_sum), mean(shear_sum)};
}

}  // namespace

line_contact::Solution solve_cylinders(const ContactCase& c, const Hertz& hertz,
                                       line_contact::Element element, long n_nodes) {
  constexpr double tolerance = 1e-12;
  return line_contact::solve_by_fft(
      {c.cylinders.profile(), c.cylinders.contact_modulus(),
       line_contact::grid_of_width(cylinder_domain * hertz.half_width(), n_nodes), element},
      c.line_load, tolerance);
}

line_contact::Solution invert_cylinders(const ContactCase& c, const Hertz& hertz) {
  return line_contact::solve_by_matrix_inversion(
      {c.cylinders.profile(), c.cylinders.contact_modulus(),
       line_contact::grid_around(hertz.half_width(), c.n_nodes)},
      c.line_load);
}

std::vector<line_contact::Grid> grids_of(const Hertz& hertz, long n_nodes, int n_places) {
  const double elements = static_cast<double>(n_nodes) / cylinder_domain;
  std::vector<line_contact::Grid> grids;
  for (int k = 0; k < n_places; ++k) {
    const double part = elements / (elements + static_cast<double>(k) / n_places);
    grids.push_back(
        line_contact::grid_of_width(part * cylinder_domain * hertz.half_width(), n_nodes));
  }
  return grids;
}

HertzErrors errors_against(const Hertz& hertz, const line_contact::Solution& solution) {
  constexpr double inner_part = 0.9;
  const double a = hertz.half_width();
  double squares = 0;
  double largest = 0;
  int n_inside = 0;
  for (Eigen::Index i = 0; i < solution.grid.n_nodes; ++i) {
    const double x = solution.grid.x(i);
    const double error = (solution.pressure[i] - hertz.pressure(x)) / hertz.peak_pressure();
    largest = std::max(largest, std::abs(error));
    if (std::abs(x) > inner_part * a) continue;
    squares += error * error;
    ++n_inside;
  }
  const line_contact::Region region = solution.regions().front();
  return {a / solution.grid.spacing,
          std::sqrt(squares / n_inside),
          largest,
          solution.peak_pressure() / hertz.peak_pressure() - 1,
          solution.half_width_by_count() / a - 1,
          (region.end - region.begin) / 2 / a - 1,
          solution.half_width() / a - 1};
}

SpacingErrors errors_at_spacing(const ContactCase& c, const Hertz& hertz,
                                line_contact::Element element, long n_nodes) {
  constexpr double tolerance = 1e-12;
  const double closed = rounded(c, 1);
  SpacingErrors at;
  double logarithms = 0;
  for (const line_contact::Grid& grid : grids_of(hertz, n_nodes)) {
    const line_contact::Solution solution = line_contact::solve_by_fft(
        {c.cylinders.profile(), c.cylinders.contact_modulus(), grid, element}, c.line_load,
        tolerance);
    at.errors.push_back(errors_against(hertz, solution));
    logarithms += std::log(at.errors.back().elements);
    at.of_pressure = std::max(at.of_pressure, pressure_error(solution) + closed);
    at.of_edge = std::max(at.of_edge, edge_error(solution) / hertz.half_width() + closed);
    at.of_moment = std::max(at.of_moment, half_width_error(solution) + closed);
  }
  at.elements = std::exp(logarithms / static_cast<double>(at.errors.size()));
  return at;
}

Estimate root_mean_square(const std::vector<Estimate>& errors) {
  double squares = 0;
  double squares_of_bounds = 0;
  for (const Estimate& error : errors) {
    squares += error.value * error.value;
    squares_of_bounds += error.abs_error * error.abs_error;
  }
  const auto n = static_cast<double>(errors.size());
  return {std::sqrt(squares / n), std::sqrt(squares_of_bounds / n)};
}

Estimate factor_of(const SpacingErrors& at, double HertzErrors::*error, double bound,
                   double order) {
  std::vector<Estimate> scaled;
  for (const HertzErrors& e : at.errors) {
    const double scale = std::pow(e.elements, order);
    scaled.push_back({e.*error * scale, bound * scale});
  }
  return root_mean_square(scaled);
}

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
