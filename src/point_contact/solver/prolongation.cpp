// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/nested_grids.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace point_contact {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Known = std::vector<bool>;

constexpr Index outside = -1;

// The index of node (i, j) if its value is known, else `outside`.
Index known_at(const Grid& grid, const Known& known, Index i, Index j) {
  if (i < 0 || i >= grid.n1 || j < 0 || j >= grid.n2) return outside;
  const Index index = grid.index(i, j);
  return known[size_of(index)] ? index : outside;
}

// Extrapolates values by one layer of nodes: each is the mean of the straight lines through two
// known nodes in a row, over the eight directions, and at most 0.
void continue_by_a_layer(const Grid& grid, VectorXd& values, Known& known) {
  constexpr std::array<std::pair<Index, Index>, 8> directions = {
      {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}}};
  const Known before = known;
  for (Index j = 0; j < grid.n2; ++j) {
    for (Index i = 0; i < grid.n1; ++i) {
      if (before[size_of(grid.index(i, j))]) continue;
      double sum = 0;
      int n = 0;
      for (const auto& [di, dj] : directions) {
        const Index near = known_at(grid, before, i + di, j + dj);
        if (near == outside) continue;
        const Index far = known_at(grid, before, i + 2 * di, j + 2 * dj);
        if (far == outside) continue;
        sum += 2 * values[near] - values[far];
        ++n;
      }
      if (n == 0) continue;
      values[grid.index(i, j)] = std::min(0.0, sum / n);
      known[size_of(grid.index(i, j))] = true;
    }
  }
}

// The position of a fine node between two coarse ones, along one side of the grids.
struct Position {
  Index lower;
  Index upper;
  double share;  // of the way to the upper one
};

Position position(Index fine_index, Index n_fine, Index n_coarse, double spacings) {
  const double from_middle = static_cast<double>(fine_index) - static_cast<double>(n_fine - 1) / 2;
  const double at = from_middle * spacings + static_cast<double>(n_coarse - 1) / 2;
  const double floor = std::floor(at);
  const auto lower = static_cast<Index>(floor);
  return {std::clamp<Index>(lower, 0, n_coarse - 1), std::clamp<Index>(lower + 1, 0, n_coarse - 1),
          at - floor};
}

}  // namespace

VectorXd prolongate(const Grid& coarse, const VectorXd& pressure, const Grid& fine) {
  // Extrapolate p² by the two layers that surround the fine nodes near the edge
  VectorXd squares = pressure.array().square();
  Known known(size_of(coarse.size()));
  for (Index i = 0; i < coarse.size(); ++i) known[size_of(i)] = pressure[i] > 0;
  const double far_outside = -squares.maxCoeff();
  continue_by_a_layer(coarse, squares, known);
  continue_by_a_layer(coarse, squares, known);
  for (Index i = 0; i < coarse.size(); ++i) {
    if (!known[size_of(i)]) squares[i] = far_outside;
  }

  const double spacings = fine.spacing / coarse.spacing;
  VectorXd result(fine.size());
  for (Index j = 0; j < fine.n2; ++j) {
    const Position y = position(j, fine.n2, coarse.n2, spacings);
    for (Index i = 0; i < fine.n1; ++i) {
      const Position x = position(i, fine.n1, coarse.n1, spacings);
      const auto along_x = [&](Index row) {
        return (1 - x.share) * squares[coarse.index(x.lower, row)] +
               x.share * squares[coarse.index(x.upper, row)];
      };
      const double square = (1 - y.share) * along_x(y.lower) + y.share * along_x(y.upper);
      result[fine.index(i, j)] = std::sqrt(std::max(0.0, square));
    }
  }
  return result;
}

}  // namespace point_contact
