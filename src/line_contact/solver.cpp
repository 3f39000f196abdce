// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/solver.hpp"

#include "contact/limits.hpp"
#include "line_contact/nested_grids.hpp"
#include "system/require.hpp"

namespace line_contact {

Solution solve_by_fft(const Problem& problem, double line_load, double tolerance) {
  require_valid(problem);
  contact::require_tolerance(tolerance, min_tolerance);
  return to_solution(problem, line_load, solve_on_nested_grids(problem, line_load, tolerance));
}

}  // namespace line_contact
