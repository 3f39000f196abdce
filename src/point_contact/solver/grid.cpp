// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/grid.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "system/require.hpp"

namespace point_contact {

Grid rectangular_grid(double width, double height, Eigen::Index n) {
  sys::require_positive("domain", width);
  sys::require_positive("domain", height);
  if (n < min_nodes || n > max_nodes) {
    throw sys::InvalidQuantity("nodes", static_cast<double>(n),
                               fmt::format("from {} to {}", min_nodes, max_nodes));
  }
  const double spacing = std::max(width, height) / static_cast<double>(n);
  const auto nodes_along = [&](double side) {
    constexpr double rounding = 1e-9;  // of a count
    return std::max(min_nodes, static_cast<Eigen::Index>(std::ceil(side / spacing - rounding)));
  };
  return {spacing, nodes_along(width), nodes_along(height)};
}

Grid square_grid(double width, Eigen::Index n) {
  return rectangular_grid(width, width, n);
}

}  // namespace point_contact
