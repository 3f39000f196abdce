// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/convergence.hpp"

#include <algorithm>
#include <cmath>

#include "line_contact/solver.hpp"
#include "paper/bounds.hpp"
#include "paper/prelude.hpp"

namespace paper {

line_contact::Solution solve_cylinders(const ContactCase& c, const Hertz& hertz,
                                       line_contact::Element element, long n_nodes) {
  constexpr double tolerance = 1e-12;
  return line_contact::solve_by_fft(
      {c.cylinders.profile(), c.cylinders.contact_modulus(),
       line_contact::grid_of_width(cylinder_domain * hertz.half_width(), n_nodes), element},
      c.line_load, tolerance);
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

}  // namespace paper
