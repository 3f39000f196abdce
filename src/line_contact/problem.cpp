// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/problem.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "system/require.hpp"

namespace line_contact {
namespace {

double require_n_nodes(Eigen::Index n_nodes) {
  if (n_nodes < min_nodes || n_nodes > max_nodes) {
    constexpr double bytes_per_node = 90;
    throw sys::InvalidQuantity(
        "nodes", static_cast<double>(n_nodes),
        fmt::format("from {} to {}, which take {:.2g} GB", min_nodes, max_nodes,
                    1e-9 * bytes_per_node * static_cast<double>(max_nodes)));
  }
  return static_cast<double>(n_nodes);
}

}  // namespace

Eigen::VectorXd Grid::nodes() const {
  return Eigen::VectorXd::NullaryExpr(n_nodes, [this](Eigen::Index i) { return x(i); });
}

Grid grid_around(double half_width, Eigen::Index n_nodes) {
  sys::require_positive("half_width", half_width);
  constexpr double margin = 1.1;
  const double n_intervals_inside = require_n_nodes(n_nodes) - 3;
  return {n_nodes, 2 * margin * half_width / n_intervals_inside};
}

Grid grid_of_width(double width, Eigen::Index n_nodes, double centre) {
  sys::require_positive("domain", width);
  return {n_nodes, width / require_n_nodes(n_nodes), sys::require_finite("centre", centre)};
}

Grid one_sided_grid(double width, Eigen::Index n_nodes) {
  sys::require_positive("domain", width);
  return {n_nodes, width / (2 * require_n_nodes(n_nodes) - 1), 0, true};
}

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
