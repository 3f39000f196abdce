// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/solution.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numbers>

#include "point_contact/elements/interior.hpp"
#include "system/require.hpp"

namespace point_contact {
namespace {

using Eigen::Index;

struct Node {
  Index i;
  Index j;
};

// Calls visit(patch) for the patch between `n` nodes, counter-clockwise, unless it carries nothing,
// as one that lies partly outside the grid does, at whose end there is no pressure.
template <std::size_t n, class Visit>
void visit_between(const Solution& solution, const std::array<Node, n>& nodes, const Visit& visit) {
  const Grid& grid = solution.grid;
  std::array<Vector2, n> corners;
  std::array<double, n> values;
  bool is_loaded = false;
  for (std::size_t k = 0; k < n; ++k) {
    if (nodes[k].i < 0 || nodes[k].i >= grid.n1) return;
    corners[k] = grid.node(nodes[k].i, nodes[k].j);
    values[k] = solution.pressure[grid.index(nodes[k].i, nodes[k].j)];
    is_loaded = is_loaded || values[k] != 0;
  }
  if (!is_loaded) return;
  if (cross(grid.lattice.first, grid.lattice.second) < 0) {
    std::ranges::reverse(corners);
    std::ranges::reverse(values);
  }
  if constexpr (n == 3) {
    visit(Patch::triangle(corners, values));
  } else {
    visit(Patch::bilinear(corners, values));
  }
}

// Calls visit(triangle) for every one that carries something.
template <class Visit>
void for_triangles(const Solution& solution, const Visit& visit) {
  const Grid& grid = solution.grid;
  for (Index j = 0; j + 1 < grid.n2; ++j) {
    // from -1, since in every second staggered row the first triangle hangs from the row above
    for (Index i = -1; i + 1 < grid.n1; ++i) {
      // the cell's diagonal runs from (i+1, j) to (i, j+1)
      const Index above = grid.neighbour(i, j, 0, 1);
      visit_between<3>(solution, {Node{i, j}, {i + 1, j}, {above, j + 1}}, visit);
      visit_between<3>(solution, {Node{above + 1, j + 1}, {above, j + 1}, {i + 1, j}}, visit);
    }
  }
}

template <class Visit>
void for_rectangles(const Solution& solution, const Visit& visit) {
  for (Index j = 0; j + 1 < solution.grid.n2; ++j) {
    for (Index i = 0; i + 1 < solution.grid.n1; ++i) {
      visit_between<4>(solution, {Node{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}, visit);
    }
  }
}

// Calls visit(place, pressure) for every node in contact.
template <class Visit>
void for_nodes(const Solution& solution, const Visit& visit) {
  const Grid& grid = solution.grid;
  for (Index j = 0; j < grid.n2; ++j) {
    for (Index i = 0; i < grid.n1; ++i) {
      const double p = solution.pressure[grid.index(i, j)];
      if (p != 0) visit(grid.node(i, j), p);
    }
  }
}

template <class Visit>
void for_cells(const Solution& solution, const Visit& visit) {
  const Lattice& lattice = solution.grid.lattice;
  const Vector2 a = lattice.first / 2;
  const Vector2 b = (cross(lattice.first, lattice.second) > 0 ? 0.5 : -0.5) * lattice.second;
  for_nodes(solution, [&](const Vector2& x, double p) {
    visit(Patch::uniform({x - a - b, x + a - b, x + a + b, x - a + b}, p));
  });
}

// Adds of_patch(patch), or of_force(place, force), up over the pressure of the solution's elements.
template <class Sum, class OfPatch, class OfForce>
Sum sum_over(const Solution& solution, Sum sum, const OfPatch& of_patch, const OfForce& of_force) {
  const auto add = [&](const Patch& patch) { sum += of_patch(patch); };
  switch (solution.element) {
    case Element::pyramid:
      for_triangles(solution, add);
      break;
    case Element::bilinear:
      for_rectangles(solution, add);
      break;
    case Element::uniform:
      for_cells(solution, add);
      break;
    case Element::point:
      const double area = solution.grid.lattice.cell_area();
      for_nodes(solution, [&](const Vector2& x, double p) { sum += of_force(x, area * p); });
      break;
  }
  return sum;
}

// The displacement of a force at the distance d on the surface: Johnson 3.18 at z = 0.
Eigen::Vector3d surface_displacement_of_force(double force, const elasticity::Material& material,
                                              const Vector2& d) {
  const double r = d.norm();
  const Vector2 inwards = -material.local_compliance() * force / (2 * std::numbers::pi * r * r) * d;
  return {inwards.x(), inwards.y(), material.integral_compliance() * force / (2 * r)};
}

}  // namespace

InteriorField field_beneath(const Solution& solution, const elasticity::Material& material,
                            const Eigen::Vector3d& at) {
  sys::require_positive("z", at.z());
  return sum_over(
      solution, InteriorField{},
      [&](const Patch& patch) { return interior_field(patch, material, at); },
      [&](const Vector2& place, double force) {
        const Eigen::Vector3d d = at - Eigen::Vector3d(place.x(), place.y(), 0);
        return field_of_force(force, material, d);
      });
}

Eigen::Vector3d displacement_of_surface(const Solution& solution,
                                        const elasticity::Material& material, const Vector2& at) {
  const Eigen::Vector3d sum = sum_over(
      solution, Eigen::Vector3d(Eigen::Vector3d::Zero()),
      [&](const Patch& patch) { return surface_displacement(patch, material, at); },
      [&](const Vector2& place, double force) {
        return surface_displacement_of_force(force, material, at - place);
      });
  sys::require_finite("displacement", sum.sum());
  return sum;
}

Vector2 slope_of_surface(const Solution& solution, double contact_modulus, const Vector2& at) {
  const Vector2 sum = sum_over(
      solution, Vector2(Vector2::Zero()),
      [&](const Patch& patch) { return surface_gradient(patch, at); },
      [&](const Vector2& place, double force) {
        const Vector2 d = at - place;
        return Vector2(-force / (d.squaredNorm() * d.norm()) * d);
      });
  sys::require_finite("slope", sum.sum());
  return sum / (std::numbers::pi * contact_modulus);
}

}  // namespace point_contact
