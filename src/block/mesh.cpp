// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "system/require.hpp"

namespace block {
namespace {

// Returns the interval of `lines` that contains `value`, and the value's position in it, from −1 to
// 1.
std::pair<Index, double> locate_between(const char* quantity, const std::vector<double>& lines,
                                        double value) {
  if (!(value >= lines.front() && value <= lines.back())) {
    throw sys::InvalidQuantity(quantity, value, "inside the block");
  }
  const auto above = std::upper_bound(lines.begin() + 1, lines.end() - 1, value);
  const double begin = *(above - 1);
  return {above - lines.begin() - 1, 2 * (value - begin) / (*above - begin) - 1};
}

// Returns the distances of the boundaries from a graded end, from `smallest` to `length`.
std::vector<double> graded_distances(double smallest, double length, double ratio) {
  if (smallest >= length) return {length};
  const double exact = std::log(smallest / length) / std::log(ratio);
  // Round up from a little less, so that rounding does not add a layer to one of two equal halves.
  const int n_layers = static_cast<int>(std::ceil(exact - 1e-9));
  std::vector<double> distances;
  for (int k = n_layers; k >= 0; --k) {
    distances.push_back(length * std::pow(smallest / length, static_cast<double>(k) / n_layers));
  }
  return distances;
}

}  // namespace

Mesh::Mesh(int order, std::vector<double> x_lines, std::vector<double> z_lines)
    : order_(order), x_lines_(std::move(x_lines)), z_lines_(std::move(z_lines)) {}

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

bool Mesh::is_interior(Index node) const {
  const Eigen::Vector2<Index> step = grid_position(node);
  return step.x() % order_ != 0 && step.y() % order_ != 0;
}

LocalPoint Mesh::locate(double x, double z) const {
  const auto [column, xi] = locate_between("x", x_lines_, x);
  const auto [row, zeta] = locate_between("z", z_lines_, z);
  return {row * n_columns() + column, xi, zeta};
}

std::vector<double> graded_lines(const std::vector<GradedPoint>& points, double ratio) {
  std::vector<double> lines{points.front().position};
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const GradedPoint& begin = points[i];
    const GradedPoint& end = points[i + 1];
    const double half = (end.position - begin.position) / 2;

    // Grade the first half away from its end and the second towards its own; the boundary in the
    // middle belongs to both
    for (const double d : graded_distances(begin.smallest, half, ratio)) {
      lines.push_back(begin.position + d);
    }
    const std::vector<double> inwards = graded_distances(end.smallest, half, ratio);
    for (auto d = inwards.rbegin() + 1; d != inwards.rend(); ++d) {
      lines.push_back(end.position - *d);
    }
    lines.push_back(end.position);
  }
  return lines;
}

}  // namespace block
