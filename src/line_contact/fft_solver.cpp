// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/fft_solver.hpp"

#include <fmt/core.h>

#include <utility>

#include "system/require.hpp"

namespace line_contact {
namespace {

// Returns a one-sided problem completed by its mirror image.
Problem both_sides(Problem problem) {
  if (problem.grid.is_one_sided) {
    problem.grid = {2 * problem.grid.n_nodes - 1, problem.grid.spacing};
  }
  return problem;
}

}  // namespace

double require_tolerance(double tolerance) {
  constexpr double too_large = 0.01;
  if (!(tolerance >= min_tolerance && tolerance < too_large)) {
    throw sys::InvalidQuantity(
        "tolerance", tolerance,
        fmt::format("from {}, which is rounding, to less than {}", min_tolerance, too_large));
  }
  return tolerance;
}

Solution solve_by_fft(const Problem& problem, double line_load, double tolerance,
                      const ProgressReport& report) {
  require_valid(problem);
  sys::require_positive("load", line_load);
  require_tolerance(tolerance);
  const Problem full = both_sides(problem);
  NestedSolution nested = solve_on_nested_grids(full, line_load, tolerance, report);
  require_free_ends(full, nested.phi, line_load);

  ElementLoads loads = element_loads(full, std::move(nested));
  if (problem.grid.is_one_sided) {
    loads.phi = loads.phi.tail(problem.grid.n_nodes).eval();
    loads.gap = loads.gap.tail(problem.grid.n_nodes).eval();
  }
  return to_solution(problem, line_load, std::move(loads));
}

}  // namespace line_contact
