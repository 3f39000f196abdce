// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/beneath.hpp"

#include <array>
#include <cstddef>
#include <utility>

#include "system/require.hpp"

namespace point_contact {
namespace {

using Eigen::Index;

struct Node {
  Index i;
  Index j;
};

// A triangle of three nodes, counter-clockwise; nothing if it carries nothing, as one that lies
// partly outside the grid does, at whose end there is no pressure.
void add_triangle(const Solution& solution, const elasticity::Material& material,
                  const Eigen::Vector3d& at, std::array<Node, 3> nodes, InteriorField& sum) {
  const Grid& grid = solution.grid;
  if (cross(grid.lattice.first, grid.lattice.second) < 0) std::swap(nodes[1], nodes[2]);
  std::array<Vector2, 3> corners;
  std::array<double, 3> values;
  for (std::size_t k = 0; k < 3; ++k) {
    if (nodes[k].i < 0 || nodes[k].i >= grid.n1) return;
    corners[k] = grid.node(nodes[k].i, nodes[k].j);
    values[k] = solution.pressure[grid.index(nodes[k].i, nodes[k].j)];
  }
  if (values[0] == 0 && values[1] == 0 && values[2] == 0) return;
  sum += interior_field(corners, values, material, at);
}

}  // namespace

InteriorField field_beneath(const Solution& solution, const elasticity::Material& material,
                            const Eigen::Vector3d& at) {
  if (solution.element != Element::pyramid) {
    throw sys::InvalidQuantity("element", static_cast<double>(solution.element),
                               "the pyramid, for the stresses in the body");
  }
  InteriorField sum;
  for (Index j = 0; j + 1 < solution.grid.n2; ++j) {
    // from -1, since in every second staggered row the first triangle hangs from the row above
    for (Index i = -1; i + 1 < solution.grid.n1; ++i) {
      // the cell's diagonal runs from (i+1, j) to (i, j+1)
      const Index above = solution.grid.neighbour(i, j, 0, 1);
      add_triangle(solution, material, at, {Node{i, j}, {i + 1, j}, {above, j + 1}}, sum);
      add_triangle(solution, material, at, {Node{above + 1, j + 1}, {above, j + 1}, {i + 1, j}},
                   sum);
    }
  }
  return sum;
}

}  // namespace point_contact
