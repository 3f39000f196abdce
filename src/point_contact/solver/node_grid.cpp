// SPDX-License-Identifier: GPL-3.0-or-later
#include <initializer_list>
#include <vector>

#include "point_contact/solver/grid.hpp"
#include "point_contact/solver/solution.hpp"

namespace point_contact {
namespace {

using Eigen::Index;

std::vector<double> nodes_of(const Grid& grid) {
  std::vector<double> coordinates;
  coordinates.reserve(3 * size_of(grid.size()));
  for (Index j = 0; j < grid.n2; ++j) {
    for (Index i = 0; i < grid.n1; ++i) {
      const Vector2 at = grid.node(i, j);
      coordinates.insert(coordinates.end(), {at.x(), at.y(), 0});
    }
  }
  return coordinates;
}

// A quadrilateral between four nodes, or two triangles.
std::vector<std::int64_t> corners_of(const Grid& grid, bool is_triangular) {
  std::vector<std::int64_t> corners;
  const auto add = [&](std::initializer_list<std::int64_t> cell) {
    corners.insert(corners.end(), cell);
  };
  for (Index j = 0; j + 1 < grid.n2; ++j) {
    // from -1, since in every second staggered row the first triangle hangs from the row above
    for (Index i = -1; i + 1 < grid.n1; ++i) {
      const Index above = grid.neighbour(i, j, 0, 1);
      const Index here = grid.index(i, j);
      const Index there = grid.index(above, j + 1);
      if (!is_triangular) {
        if (i >= 0) add({here, here + 1, there + 1, there});
        continue;
      }
      if (i >= 0) add({here, here + 1, there});
      if (above >= 0 && above + 1 < grid.n1) add({here + 1, there + 1, there});
    }
  }
  return corners;
}

std::vector<double> copy_of(const Eigen::VectorXd& values) {
  return {values.begin(), values.end()};
}

}  // namespace

numerics::UnstructuredGrid node_grid(const Solution& solution, const Eigen::VectorXd& shear) {
  const bool is_triangular = solution.grid.is_staggered || solution.element == Element::pyramid;
  numerics::UnstructuredGrid grid{
      .points = nodes_of(solution.grid),
      .n_corners = is_triangular ? 3 : 4,
      .corners = corners_of(solution.grid, is_triangular),
      .fields = {{"pressure", 1, copy_of(solution.pressure)}, {"gap", 1, copy_of(solution.gap)}}};
  if (shear.size() > 0) grid.fields.push_back({"shear", 1, copy_of(shear)});
  return grid;
}

}  // namespace point_contact
