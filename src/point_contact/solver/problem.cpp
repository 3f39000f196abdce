// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/problem.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/limits.hpp"
#include "system/require.hpp"

namespace point_contact {

Eigen::VectorXd initial_gaps(const Problem& problem) {
  sys::require_positive("contact_modulus", problem.contact_modulus);
  const Grid& grid = problem.grid;
  const Eigen::Index longer = std::max(grid.n1, grid.n2);
  if (std::min(grid.n1, grid.n2) < min_nodes || longer > max_nodes) {
    throw sys::InvalidQuantity("nodes", static_cast<double>(longer),
                               fmt::format("from {} to {}", min_nodes, max_nodes));
  }
  const Vector2 corner = grid.node(grid.n1 - 1, grid.n2 - 1);
  const Vector2& half_sides = problem.profile.half_sides();
  if (!(corner.array() <= half_sides.array()).all()) {
    throw sys::InvalidQuantity(
        "domain", static_cast<double>(grid.n1) * grid.spacing,
        fmt::format("within the measured surface, |x| ≤ {:.6g}, |y| ≤ {:.6g}; its corner is at "
                    "({:.6g}, {:.6g})",
                    half_sides.x(), half_sides.y(), corner.x(), corner.y()));
  }
  Eigen::VectorXd gaps(grid.size());
  for (Eigen::Index j = 0; j < grid.n2; ++j) {
    for (Eigen::Index i = 0; i < grid.n1; ++i) {
      gaps[grid.index(i, j)] = problem.profile.gap(grid.node(i, j));
    }
  }
  const double largest = gaps.cwiseAbs().maxCoeff();
  if (!(largest < contact::largest_length)) {
    throw sys::InvalidQuantity("largest gap on the grid", largest,
                               fmt::format("less than {}", contact::largest_length));
  }
  return gaps;
}

double total_phi(const Problem& problem, double load) {
  sys::require_positive("load", load);
  const double total = load / (std::numbers::pi * problem.contact_modulus * problem.grid.spacing);
  if (!(total < contact::largest_length)) {
    throw sys::InvalidQuantity(
        "load", load, fmt::format("less than {:.3g}", load / total * contact::largest_length));
  }
  return total;
}

}  // namespace point_contact
