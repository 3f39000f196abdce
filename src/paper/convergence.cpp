// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/convergence.hpp"

#include <algorithm>
#include <cmath>

#include "line_contact/fft_solver.hpp"
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

ConvergenceStudy convergence_study(const ContactCase& c, const Hertz& hertz,
                                   line_contact::Element element) {
  constexpr int n_grids = 80;
  constexpr double coarsest = 33;
  constexpr double finest = 50 * coarsest;
  ConvergenceStudy study;
  for (int k = 0; k < n_grids; ++k) {
    const double share = k / (n_grids - 1.0);
    const long n_nodes = std::lround(coarsest * std::pow(finest / coarsest, share));
    const line_contact::Solution solution = solve_cylinders(c, hertz, element, n_nodes);
    const HertzErrors e = errors_against(hertz, solution);
    study.elements.push_back(e.elements);
    study.inside.push_back(e.inside);
    study.largest.push_back(e.largest);
    study.peak.push_back(e.peak);
    study.count.push_back(e.half_width_count);
    study.extrapolated.push_back(e.half_width_extrapolated);
    study.moment.push_back(e.half_width_moment);
    const double closed = rounded(c, 1);
    study.of_pressure.push_back(pressure_error(solution) + closed);
    study.of_edge.push_back(edge_error(solution) / hertz.half_width() + closed);
    study.of_moment.push_back(half_width_error(solution) + closed);
  }
  return study;
}

}  // namespace paper
