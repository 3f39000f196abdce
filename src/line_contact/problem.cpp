// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/problem.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "contact/limits.hpp"
#include "system/require.hpp"

namespace line_contact {
namespace {

double require_n_nodes(Eigen::Index n_nodes) {
  if (n_nodes < min_nodes || n_nodes > max_nodes) {
    throw sys::InvalidQuantity("nodes", static_cast<double>(n_nodes),
                               fmt::format("from {} to {}", min_nodes, max_nodes));
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

void require_valid(const Problem& problem) {
  sys::require_positive("contact_modulus", problem.contact_modulus);
  const Grid& grid = problem.grid;
  const Profile& profile = problem.profile;
  require_n_nodes(grid.n_nodes);
  if (grid.x(0) < profile.begin() || grid.x(grid.n_nodes - 1) > profile.end()) {
    throw sys::InvalidQuantity("domain", grid.width(),
                               fmt::format("within the profile's points, from {:.6g} to {:.6g}",
                                           profile.begin(), profile.end()));
  }
  double largest = 0;
  for (Eigen::Index i = 0; i < grid.n_nodes; ++i) {
    const double gap = profile.gap(grid.x(i));
    largest = std::max(largest, std::abs(gap));
    if (std::abs(gap) < contact::largest_length) continue;
    throw sys::InvalidQuantity(fmt::format("gap at x = {:.6g}", grid.x(i)), gap,
                               fmt::format("less than {}", contact::largest_length));
  }
  // The iterative methods square lengths; the squares must not underflow.
  constexpr double least_length = 1e-130;
  if (largest > 0 && largest < least_length) {
    throw sys::InvalidQuantity("largest gap on the grid", largest,
                               fmt::format("0 or at least {}", least_length));
  }
}

}  // namespace line_contact
