// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/mesh.hpp"

#include <algorithm>
#include <utility>

#include "block/lobatto_basis.hpp"
#include "system/require.hpp"

namespace block {
namespace {

int require_order(int order) {
  if (order < 1 || order > 12) throw sys::InvalidQuantity("order", order, "1 to 12");
  return order;
}

void require_rising(const char* quantity, const std::vector<double>& lines) {
  if (lines.size() < 2) {
    throw sys::InvalidQuantity(quantity, static_cast<double>(lines.size()), "two or more");
  }
  sys::require_finite(quantity, lines.front());
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (!(sys::require_finite(quantity, lines[i]) > lines[i - 1])) {
      throw sys::InvalidQuantity(quantity, lines[i], "greater than the line before");
    }
  }
}

// Returns the interval of `lines` that holds `value`, and the place of the value in it, from −1
// to 1.
std::pair<Index, double> locate_between(const char* quantity, const std::vector<double>& lines,
                                        double value) {
  if (!(value >= lines.front() && value <= lines.back())) {
    throw sys::InvalidQuantity(quantity, value, "inside the block");
  }
  const auto above = std::upper_bound(lines.begin() + 1, lines.end() - 1, value);
  const double begin = *(above - 1);
  return {above - lines.begin() - 1, 2 * (value - begin) / (*above - begin) - 1};
}

double coordinate(const std::vector<double>& lines, const Eigen::VectorXd& nodes, Index step,
                  int order) {
  const auto i = static_cast<std::size_t>(step / order);
  if (step % order == 0) return lines[i];
  return lines[i] + (lines[i + 1] - lines[i]) * (1 + nodes[step % order]) / 2;
}

}  // namespace

Mesh::Mesh(int order, std::vector<double> x_lines, std::vector<double> z_lines)
    : order_(require_order(order)),
      x_lines_(std::move(x_lines)),
      z_lines_(std::move(z_lines)),
      nodes_(lobatto_rule(order_ + 1).points) {
  require_rising("x_lines", x_lines_);
  require_rising("z_lines", z_lines_);
}

Element Mesh::element(Index index) const {
  const Index column = index % n_columns();
  const Index row = index / n_columns();
  const auto c = static_cast<std::size_t>(column);
  const auto r = static_cast<std::size_t>(row);
  return {column, row, x_lines_[c], x_lines_[c + 1], z_lines_[r], z_lines_[r + 1]};
}

Index Mesh::node(const Element& element, int i, int j) const {
  return (element.row * order_ + j) * n_nodes_along_x() + element.column * order_ + i;
}

Eigen::Vector2<Index> Mesh::grid_position(Index node) const {
  return {node % n_nodes_along_x(), node / n_nodes_along_x()};
}

Eigen::Vector2d Mesh::position(Index node) const {
  const Eigen::Vector2<Index> step = grid_position(node);
  return {coordinate(x_lines_, nodes_, step.x(), order_),
          coordinate(z_lines_, nodes_, step.y(), order_)};
}

bool Mesh::is_interior(Index node) const {
  const Eigen::Vector2<Index> step = grid_position(node);
  return step.x() % order_ != 0 && step.y() % order_ != 0;
}

LocalPoint Mesh::locate(double x, double z) const {
  const auto [column, xi] = locate_between("x", x_lines_, x);
  const auto [row, zeta] = locate_between("z", z_lines_, z);
  return {row * n_columns() + column, xi, zeta};
}

}  // namespace block
