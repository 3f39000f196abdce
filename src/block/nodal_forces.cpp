// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/nodal_forces.hpp"

#include <algorithm>

#include "system/require.hpp"

namespace block {
namespace {

// Returns ∫ N_i(x) p(x) dx over the part of an element's top edge that one piece of the pressure
// covers.
Eigen::VectorXd edge_forces(const LobattoBasis& basis, const Element& element,
                            const numerics::Piece& piece, const GaussRule& rule) {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(basis.order() + 1);
  const double begin = std::max(piece.begin, element.x0);
  const double end = std::min(piece.end, element.x1);
  if (begin >= end) return forces;
  for (Index k = 0; k < rule.points.size(); ++k) {
    const double t = (1 + rule.points[k]) / 2;
    const double x = begin + (end - begin) * t * t * (3 - 2 * t);
    const double dx = (end - begin) * 6 * t * (1 - t) * rule.weights[k] / 2;
    const double xi = 2 * (x - element.x0) / element.width() - 1;
    forces += dx * piece.value(x) * basis.values(xi);
  }
  return forces;
}

}  // namespace

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

Eigen::VectorXd surface_forces(const Mesh& mesh, const LobattoBasis& basis,
                               const elasticity::Load& load) {
  require_inside(load, mesh.x_lines().front(), mesh.x_lines().back());

  // In t the integrand has three times the degree of N_i and of a quartic pressure, plus two from
  // dx/dt; a rule of n points is exact to degree 2n − 1
  const GaussRule rule = gauss_rule(2 * mesh.order() + 10);
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(2 * mesh.n_nodes());
  for (Index column = 0; column < mesh.n_columns(); ++column) {
    const Element element = mesh.element(column);
    for (const numerics::Piece& piece : load.normal.pieces()) {
      const Eigen::VectorXd part = edge_forces(basis, element, piece, rule);
      for (int i = 0; i <= mesh.order(); ++i) forces[2 * mesh.node(element, i, 0) + 1] += part[i];
    }
  }
  return forces;
}

}  // namespace block
