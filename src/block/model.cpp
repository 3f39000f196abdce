// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/model.hpp"

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

}  // namespace block
