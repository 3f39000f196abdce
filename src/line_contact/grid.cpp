// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/grid.hpp"

#include <fmt/core.h>

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

}  // namespace line_contact
