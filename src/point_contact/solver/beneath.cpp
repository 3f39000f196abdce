// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/beneath.hpp"

#include <array>
#include <cstddef>
#include <utility>

#include "point_contact/elements/surface.hpp"
#include "system/require.hpp"

namespace point_contact {
namespace {

using Eigen::Index;

struct Node {
  Index i;
  Index j;
};

// Calls visit(corners, values) for a triangle of three nodes, counter-clockwise, unless it carries
// nothing, as one that lies partly outside the grid does, at whose end there is no pressure.
template <class Visit>
void visit_triangle(const Solution& solution, std::array<Node, 3> nodes, const Visit& visit) {
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
  visit(corners, values);
}

// Calls visit(corners, values) for every triangle that carries something.
template <class Visit>
void for_triangles(const Solution& solution, const Visit& visit) {
  if (solution.element != Element::pyramid) {
    throw sys::InvalidQuantity("element", static_cast<double>(solution.element),
                               "the pyramid, for what happens in the body");
  }
  const Grid& grid = solution.grid;
  for (Index j = 0; j + 1 < grid.n2; ++j) {
    // from -1, since in every second staggered row the first triangle hangs from the row above
    for (Index i = -1; i + 1 < grid.n1; ++i) {
      // the cell's diagonal runs from (i+1, j) to (i, j+1)
      const Index above = grid.neighbour(i, j, 0, 1);
      visit_triangle(solution, {Node{i, j}, {i + 1, j}, {above, j + 1}}, visit);
      visit_triangle(solution, {Node{above + 1, j + 1}, {above, j + 1}, {i + 1, j}}, visit);
    }
  }
}

}  // namespace

InteriorField field_beneath(const Solution& solution, const elasticity::Material& material,
                            const Eigen::Vector3d& at) {
  InteriorField sum;
  for_triangles(solution, [&](const auto& corners, const auto& values) {
    sum += interior_field(corners, values, material, at);
  });
  return sum;
}

Eigen::Vector3d displacement_of_surface(const Solution& solution,
                                        const elasticity::Material& material, const Vector2& at) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for_triangles(solution, [&](const auto& corners, const auto& values) {
    sum += surface_displacement(corners, values, material, at);
  });
  return sum;
}

}  // namespace point_contact
