// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/problem.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "system/require.hpp"

namespace line_contact {

void require_valid(const Problem& problem) {
  sys::require_positive("contact_modulus", problem.contact_modulus);
  const Grid& grid = problem.grid;
  const Profile& profile = problem.profile;
  if (grid.is_one_sided && !profile.is_symmetric()) {
    throw sys::InvalidQuantity("one-sided grid's end", grid.end(), "only for a symmetric profile");
  }
  const double last = grid.x(grid.n_nodes - 1);
  const double first = grid.is_one_sided ? -last : grid.x(0);
  if (first < profile.begin() || last > profile.end()) {
    throw sys::InvalidQuantity(
        "domain", grid.end() - grid.begin(),
        fmt::format("within the profile's points, from {} to {}", profile.begin(), profile.end()));
  }
  double largest = 0;
  for (Eigen::Index i = 0; i < grid.n_nodes; ++i) {
    const double gap = profile.gap(grid.x(i));
    largest = std::max(largest, std::abs(gap));
    if (std::abs(gap) < largest_length) continue;
    throw sys::InvalidQuantity(fmt::format("gap at x = {}", grid.x(i)), gap,
                               fmt::format("less than {}", largest_length));
  }
  // Methods that iterate square lengths, which must not become zero by it.
  constexpr double least_length = 1e-130;
  if (largest > 0 && largest < least_length) {
    throw sys::InvalidQuantity("largest gap on the grid", largest,
                               fmt::format("0 or at least {}", least_length));
  }
}

}  // namespace line_contact
