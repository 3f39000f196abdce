// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/exports.hpp"

#include <fmt/core.h>

#include <ostream>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "block/nodal_forces.hpp"
#include "system/require.hpp"

namespace block {
namespace {

// Two lines that are closer than this part of the block's width are one.
constexpr double same_line = 1e-9;

std::vector<double> subdivided(const std::vector<double>& lines, int n_parts) {
  std::vector<double> result{lines.front()};
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    for (int k = 1; k < n_parts; ++k) {
      result.push_back(lines[i] + (lines[i + 1] - lines[i]) * k / n_parts);
    }
    result.push_back(lines[i + 1]);
  }
  return result;
}

void write_nodes(std::ostream& out, const Mesh& mesh) {
  out << "*NODE, NSET=ALL\n";
  for (Index node = 0; node < mesh.n_nodes(); ++node) {
    if (mesh.is_interior(node)) continue;  // CPE8 has no node in the centre of an element
    const Eigen::Vector2d position = mesh.position(node);
    out << fmt::format("{}, {:.13g}, {:.13g}\n", node + 1, position.x(), 0.0 - position.y());
  }
}

// Writes the nodes of each element: its corners, counter-clockwise as one sees them with y up, and
// then the middles of the edges between them.
void write_elements(std::ostream& out, const Mesh& mesh) {
  constexpr std::array<std::array<int, 2>, 8> steps{
      {{0, 2}, {2, 2}, {2, 0}, {0, 0}, {1, 2}, {2, 1}, {1, 0}, {0, 1}}};
  out << "*ELEMENT, TYPE=CPE8, ELSET=BLOCK\n";
  for (Index index = 0; index < mesh.n_elements(); ++index) {
    const Element element = mesh.element(index);
    std::string line = fmt::format("{}", index + 1);
    for (const auto& [i, j] : steps) line += fmt::format(", {}", mesh.node(element, i, j) + 1);
    out << fmt::format("{}\n", line);
  }
}

void write_supports(std::ostream& out, const Mesh& mesh, const Supports& supports) {
  std::string held;
  const auto hold = [&](bool is_on_side, Support support, Index node, int normal) {
    if (!is_on_side || support == Support::free) return;
    const int first = support == Support::clamped ? 1 : normal;
    const int last = support == Support::clamped ? 2 : normal;
    held += fmt::format("{}, {}, {}\n", node + 1, first, last);
  };
  for (Index node = 0; node < mesh.n_nodes(); ++node) {
    const Eigen::Vector2<Index> step = mesh.grid_position(node);
    hold(step.x() == 0, supports.left, node, 1);
    hold(step.x() == mesh.n_nodes_along_x() - 1, supports.right, node, 1);
    hold(step.y() == 0, supports.top, node, 2);
    hold(step.y() == mesh.n_nodes_along_z() - 1, supports.bottom, node, 2);
  }
  out << fmt::format("*BOUNDARY\n{}", held);
}

void write_loads(std::ostream& out, const Eigen::VectorXd& forces) {
  out << "*CLOAD\n";
  for (Index k = 0; k < forces.size(); ++k) {
    if (forces[k] == 0) continue;
    const bool is_vertical = k % 2 == 1;
    out << fmt::format("{}, {}, {:.13g}\n", k / 2 + 1, is_vertical ? 2 : 1,
                       is_vertical ? -forces[k] : forces[k]);
  }
}

}  // namespace

Mesh calculix_mesh(const Mesh& mesh, const std::vector<double>& points) {
  const int n_parts = (mesh.order() + 1) / 2;
  std::vector<double> columns = subdivided(mesh.x_lines(), n_parts);
  const double tolerance = same_line * (columns.back() - columns.front());
  for (const double x : points) {
    if (!(x >= columns.front() && x <= columns.back())) {
      throw sys::InvalidQuantity("point", x, "on the top of the block");
    }
    const auto above = std::lower_bound(columns.begin(), columns.end(), x - tolerance);
    if (std::abs(*above - x) > tolerance) columns.insert(above, x);
  }
  return {2, columns, subdivided(mesh.z_lines(), n_parts)};
}

Index calculix_node(const Mesh& quadratic, double x) {
  const double width = quadratic.x_lines().back() - quadratic.x_lines().front();
  for (Index node = 0; node < quadratic.n_nodes_along_x(); ++node) {
    if (std::abs(quadratic.position(node).x() - x) <= same_line * width) return node + 1;
  }
  throw sys::InvalidQuantity("point", x, "where the deck's mesh has a node");
}

void write_calculix_deck(std::ostream& out, const Mesh& quadratic,
                         const elasticity::Material& material, const Supports& supports,
                         const elasticity::Load& load, const std::vector<double>& points) {
  if (quadratic.order() != 2) {
    throw sys::InvalidQuantity("order of the deck's mesh", quadratic.order(), "2");
  }
  require_no_rigid_motion(supports);
  const Eigen::VectorXd forces = surface_forces(quadratic, LobattoBasis(2), load);

  out << "*HEADING\nRectangular block in plane strain, unit thickness, y up\n";
  write_nodes(out, quadratic);
  write_elements(out, quadratic);
  out << "*NSET, NSET=POINTS\n";
  for (const double x : points) out << fmt::format("{}\n", calculix_node(quadratic, x));
  out << fmt::format("*MATERIAL, NAME=SOLID\n*ELASTIC\n{:.13g}, {:.13g}\n", material.young(),
                     material.poisson());
  out << "*SOLID SECTION, ELSET=BLOCK, MATERIAL=SOLID\n1.\n";
  write_supports(out, quadratic, supports);
  out << "*STEP\n*STATIC\n";
  write_loads(out, forces);
  out << fmt::format(
      "*NODE PRINT, NSET=POINTS\nU\n*NODE FILE, OUTPUT=2D\nU\n*EL FILE\nS\n*END STEP\n");
}

}  // namespace block
