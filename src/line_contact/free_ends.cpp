// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/fft_solver.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "line_contact/nested_grids.hpp"
#include "system/require.hpp"

namespace line_contact {
namespace {

// The message suggests a domain that is this many times as wide as the contact.
constexpr double suggested_margin = 1.1;

// The domain is doubled until the contact ends inside it. A contact that filled the previous domain
// reaches at least a quarter of the doubled width, 32 of these spacings, from the centre: its edge
// is known to one spacing, three per cent, which is within the margin. Only the edge is needed, so
// the pressure itself may be inaccurate.
constexpr Eigen::Index n_trial_nodes = 128;
constexpr double trial_tolerance = 1e-3;

// Enough doublings to exceed any meaningful length.
constexpr int max_doublings = 60;

// Returns the width of a domain about the same centre in which the contact has free ends, or
// nothing if the profile ends before.
std::optional<double> domain_needed(const Problem& problem, double line_load) {
  const double centre = problem.grid.centre;
  const double largest =
      2 * std::min(centre - problem.profile.begin(), problem.profile.end() - centre);
  double width = problem.grid.end() - problem.grid.begin();
  for (int doubling = 0; doubling < max_doublings && width < largest; ++doubling) {
    width = std::min(2 * width, largest);
    Problem wider = problem;
    wider.grid = grid_of_width(width, n_trial_nodes, centre);
    const NestedSolution found = solve_on_nested_grids(wider, line_load, trial_tolerance);
    const std::vector<Region> regions = regions_in_contact(wider.grid, found.phi);
    if (regions.empty()) return std::nullopt;
    const double reach =
        std::max(centre - regions.front().begin, regions.back().end - centre) / width;
    if (suggested_margin * reach < 0.5) return 2 * suggested_margin * reach * width;
  }
  return std::nullopt;
}

}  // namespace

void require_free_ends(const Problem& problem, const Eigen::VectorXd& pressure, double line_load) {
  const Grid& grid = problem.grid;
  const bool at_begin = !grid.is_one_sided && pressure[0] > 0;
  if (!at_begin && !(pressure[grid.n_nodes - 1] > 0)) return;

  Problem both_sides = problem;
  both_sides.grid.is_one_sided = false;
  if (grid.is_one_sided) both_sides.grid = grid_of_width(grid.end() - grid.begin(), grid.n_nodes);
  const std::optional<double> needed = domain_needed(both_sides, line_load);
  if (!needed) {
    throw sys::InvalidQuantity("domain", grid.end() - grid.begin(),
                               fmt::format("wider than the profile, which is given only from x = "
                                           "{} to {}: contact reaches its end",
                                           problem.profile.begin(), problem.profile.end()));
  }
  // The end nodes lie half a spacing inside the domain, and must be free.
  const auto n = static_cast<double>(grid.is_one_sided ? 2 * grid.n_nodes - 1 : grid.n_nodes);
  const double width = *needed * n / (n - 2);
  const double end = at_begin ? grid.begin() : grid.end();
  throw sys::InvalidQuantity(
      "domain", grid.end() - grid.begin(),
      fmt::format("at least {:.3g}, or contact reaches its end at x = {}", width, end));
}

}  // namespace line_contact
