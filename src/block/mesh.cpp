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

namespace {

// Kinks closer than this fraction of the width are one kink, separated by rounding or a change of
// units.
constexpr double same_place = 1e-9;

double lesser_side(const Rectangle& block) {
  return std::min(block.width(), block.height());
}

// The distance from a kink to the nearest other one, at most `most`.
double spacing_beside(const std::vector<double>& kinks, std::size_t i, double most) {
  if (i > 0) most = std::min(most, kinks[i] - kinks[i - 1]);
  if (i + 1 < kinks.size()) most = std::min(most, kinks[i + 1] - kinks[i]);
  return most;
}

// Returns the kinks and the sides of the block, each with the size of the elements beside it.
std::vector<GradedPoint> graded_columns(const Rectangle& block, const std::vector<double>& kinks,
                                        double fraction) {
  const double corner = fraction * lesser_side(block);
  std::vector<GradedPoint> points;
  for (std::size_t i = 0; i < kinks.size(); ++i) {
    points.push_back({kinks[i], fraction * spacing_beside(kinks, i, block.width())});
  }

  // The outermost points are the sides; a kink within rounding of a side is moved onto it
  const double hair = same_place * block.width();
  if (kinks.front() - block.left() > hair) points.insert(points.begin(), {block.left(), corner});
  if (block.right() - kinks.back() > hair) points.push_back({block.right(), corner});
  points.front().position = block.left();
  points.back().position = block.right();
  return points;
}

// The magnitude of the pressure's jump at x.
double jump_at(double x, double hair, const numerics::PiecewiseFunction& pressure) {
  double jump = 0;
  for (const numerics::Piece& piece : pressure.pieces()) {
    if (std::abs(piece.begin - x) <= hair) jump += piece.value(piece.begin);
    if (std::abs(piece.end - x) <= hair) jump -= piece.value(piece.end);
  }
  return std::abs(jump);
}

}  // namespace

void require_valid(const Discretization& discretization) {
  if (discretization.order < 4 || discretization.order > 10) {
    throw sys::InvalidQuantity("order", discretization.order, "4 to 10");
  }
  if (discretization.refine < 1 || discretization.refine > 4) {
    throw sys::InvalidQuantity("refine", discretization.refine, "1 to 4");
  }
}

Discretization coarser(const Discretization& discretization) {
  return {discretization.order - 1, discretization.refine - 1};
}

std::vector<double> kinks_of(const std::vector<elasticity::Load>& loads) {
  std::vector<double> kinks;
  for (const elasticity::Load& load : loads) {
    for (const numerics::Piece& piece : load.normal.pieces()) {
      kinks.insert(kinks.end(), {piece.begin, piece.end});
    }
  }
  std::sort(kinks.begin(), kinks.end());
  if (kinks.empty()) return kinks;
  const double hair = same_place * (kinks.back() - kinks.front());
  const auto is_same = [hair](double kink, double next) { return next - kink <= hair; };
  kinks.erase(std::unique(kinks.begin(), kinks.end(), is_same), kinks.end());
  return kinks;
}

void require_inside(const elasticity::Load& load, double left, double right) {
  if (!load.forces.empty()) {
    throw sys::InvalidQuantity("concentrated force", load.forces.front().magnitude,
                               "absent: under it the displacement is infinite; spread it "
                               "over a width");
  }
  for (const numerics::Piece& piece : load.normal.pieces()) {
    if (piece.begin < left) {
      throw sys::InvalidQuantity("begin of the load", piece.begin, "on the block");
    }
    if (piece.end > right) {
      throw sys::InvalidQuantity("end of the load", piece.end, "on the block");
    }
  }
}

Mesh graded_mesh(const Rectangle& block, const std::vector<elasticity::Load>& loads,
                 const Discretization& discretization) {
  for (const elasticity::Load& load : loads) require_inside(load, block.left(), block.right());
  const std::vector<double> kinks = kinks_of(loads);
  if (kinks.empty()) {
    throw sys::InvalidQuantity("number of loads", static_cast<double>(loads.size()),
                               "1 or more, with a pressure that is not zero");
  }

  const double fraction = 0.2 * std::pow(0.3, discretization.refine);
  const double ratio = 0.2 + 0.07 * discretization.refine;
  const std::vector<GradedPoint> columns = graded_columns(block, kinks, fraction);
  const double corner = fraction * lesser_side(block);
  double smallest = corner;
  for (const GradedPoint& column : columns) smallest = std::min(smallest, column.smallest);
  return {discretization.order, graded_lines(columns, ratio),
          graded_lines({{0, smallest}, {block.height(), corner}}, ratio)};
}

bool Disc::holds(const Eigen::Vector2d& point) const {
  return std::hypot(point.x() - x, point.y() - z) < radius;
}

std::vector<Disc> discs_without_limit(const Rectangle& block, const Supports& supports,
                                      const elasticity::Load& load) {
  // A smaller jump is hidden by other errors
  constexpr double least_jump = 1e-6;
  std::vector<Disc> discs;
  const std::vector<double> kinks = kinks_of({load});
  for (std::size_t i = 0; i < kinks.size(); ++i) {
    const double hair = same_place * (kinks.back() - kinks.front());
    if (jump_at(kinks[i], hair, load.normal) > least_jump * load.normal.scale()) {
      discs.push_back({kinks[i], 0, spacing_beside(kinks, i, block.width()) / 4});
    }
  }

  const double radius = lesser_side(block) / 10;
  for (const auto& [side, x] :
       {std::pair{supports.left, block.left()}, std::pair{supports.right, block.right()}}) {
    if (side == Support::clamped) discs.push_back({x, 0, radius});
    const auto [least, most] = std::minmax({side, supports.bottom});
    if (least == Support::free && most == Support::clamped) {
      discs.push_back({x, block.height(), radius});
    }
  }
  return discs;
}

}  // namespace block
