// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/model.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace block {

Model::Model(Mesh mesh, const elasticity::Material& material)
    : mesh_(std::move(mesh)),
      material_(material),
      lame_(block::lame(material)),
      basis_(mesh_.order()),
      integrals_(basis_.integrals()),
      stacked_(integrals_),
      split_(split_unknowns(mesh_.order())) {
  std::map<double, std::shared_ptr<const CondensedStiffness>> by_aspect;
  condensed_.reserve(static_cast<std::size_t>(mesh_.n_elements()));
  for (Index index = 0; index < mesh_.n_elements(); ++index) {
    const Element e = mesh_.element(index);
    auto& condensed = by_aspect[e.height() / e.width()];
    if (!condensed) {
      condensed = std::make_shared<const CondensedStiffness>(
          condense(element_stiffness(integrals_, lame_, e.height() / e.width()), split_));
    }
    condensed_.push_back(condensed);
  }
}

const CondensedStiffness& Model::condensed(Index element) const {
  return *condensed_[static_cast<std::size_t>(element)];
}

std::vector<Index> Model::unknowns(Index element) const {
  const Element e = mesh_.element(element);
  const int p = mesh_.order();
  std::vector<Index> numbers;
  numbers.reserve(2 * static_cast<std::size_t>((p + 1) * (p + 1)));
  for (int j = 0; j <= p; ++j) {
    for (int i = 0; i <= p; ++i) {
      for (int c = 0; c < 2; ++c) numbers.push_back(2 * mesh_.node(e, i, j) + c);
    }
  }
  return numbers;
}

Eigen::VectorXd Model::internal_forces(const Eigen::VectorXd& displacements) const {
  const Index n = mesh_.order() + 1;
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(displacements.size());
  Eigen::MatrixXd local(n, 2 * n);
  for (Index index = 0; index < mesh_.n_elements(); ++index) {
    const Element e = mesh_.element(index);
    const std::vector<Index> numbers = unknowns(index);
    const Eigen::VectorXd gathered = displacements(numbers);
    for (Index c = 0; c < 2; ++c) {
      const Eigen::VectorXd component = gathered(Eigen::seqN(c, n * n, 2));
      local.middleCols(c * n, n).reshaped() = component.array() - component.mean();
    }
    const Eigen::MatrixXd f = element_forces(stacked_, lame_, e.height() / e.width(), local);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      const auto node = static_cast<Index>(k) / 2;
      forces[numbers[k]] += f(node % n, static_cast<Index>(k) % 2 * n + node / n);
    }
  }
  return forces;
}

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
