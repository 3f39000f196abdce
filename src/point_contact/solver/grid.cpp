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

double Grid::shift(Eigen::Index j) const {
  if (!is_staggered) return 0;
  return j % 2 == 0 ? -0.25 : 0.25;
}

Vector2 Grid::between_rows() const {
  return is_staggered ? Vector2(lattice.second - lattice.first / 2) : lattice.second;
}

Vector2 Grid::node(Eigen::Index i, Eigen::Index j) const {
  const double along = static_cast<double>(i) - static_cast<double>(n1 - 1) / 2 + shift(j);
  return centre + along * lattice.first +
         (static_cast<double>(j) - static_cast<double>(n2 - 1) / 2) * between_rows();
}

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
