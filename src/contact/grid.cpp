// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/grid.hpp"

#include <fmt/core.h>

#include "numerics/require.hpp"

namespace contact {

Eigen::VectorXd Grid::nodes() const {
  return Eigen::VectorXd::NullaryExpr(n_nodes, [this](Eigen::Index i) { return x(i); });
}

Grid grid_around(double half_width, long n_nodes) {
  numerics::require_positive("half_width", half_width);
  if (n_nodes < min_nodes || n_nodes > max_nodes) {
    throw numerics::InvalidQuantity("nodes", static_cast<double>(n_nodes),
                                    fmt::format("from {} to {}", min_nodes, max_nodes));
  }
  constexpr double margin = 1.1;
  const double n_intervals_inside = static_cast<double>(n_nodes - 1) - 2;
  return {n_nodes, 2 * margin * half_width / n_intervals_inside};
}

}  // namespace contact
