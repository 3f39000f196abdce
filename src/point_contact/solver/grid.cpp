// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/grid.hpp"

#include <fmt/core.h>

#include <cmath>
#include <numbers>

#include "system/require.hpp"

namespace point_contact {
namespace {

double require_n(Eigen::Index n) {
  if (n < min_nodes) {
    throw sys::InvalidQuantity("nodes a side", static_cast<double>(n),
                               fmt::format("{} or more", min_nodes));
  }
  return static_cast<double>(n);
}

}  // namespace

Grid rectangular_grid(double width, double height, Eigen::Index n) {
  sys::require_positive("domain width", width);
  sys::require_positive("domain height", height);
  const double count = require_n(n);
  return {{{width / count, 0}, {0, height / count}}, n, n};
}

Grid square_grid(double width, Eigen::Index n) {
  return rectangular_grid(width, width, n);
}

Grid hexagonal_grid(double width, Eigen::Index n, double stretch) {
  sys::require_positive("domain width", width);
  sys::require_positive("stretch", stretch);
  Lattice lattice = hexagonal_lattice(width / require_n(n));
  lattice.second.y() *= stretch;
  const double n_rows = std::ceil(static_cast<double>(n) * 2 / std::numbers::sqrt3);
  return {
      .lattice = lattice, .n1 = n, .n2 = static_cast<Eigen::Index>(n_rows), .is_staggered = true};
}

Grid Grid::with_nodes(Eigen::Index new_n1, Eigen::Index new_n2) const {
  Grid grid = *this;
  grid.n1 = new_n1;
  grid.n2 = new_n2;
  grid.lattice.first = lattice.first * (static_cast<double>(n1) / static_cast<double>(new_n1));
  grid.lattice.second = between_rows() * (static_cast<double>(n2) / static_cast<double>(new_n2));
  if (is_staggered) grid.lattice.second += grid.lattice.first / 2;
  return grid;
}

}  // namespace point_contact
