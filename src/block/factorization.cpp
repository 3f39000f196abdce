// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/factorization.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "block/model.hpp"

namespace block {
namespace {

std::vector<Index> select(const std::vector<Index>& numbers, const std::vector<int>& which) {
  std::vector<Index> selected;
  selected.reserve(which.size());
  for (const int local : which) selected.push_back(numbers[static_cast<std::size_t>(local)]);
  return selected;
}

// Whether the supports fix a displacement component of a node.
bool is_held(const Mesh& mesh, const Supports& supports, Index node, int component) {
  const Eigen::Vector2<Index> step = mesh.grid_position(node);
  const auto holds = [](bool on_side, Support support, bool is_normal) {
    return on_side && (support == Support::clamped || (support == Support::roller && is_normal));
  };
  return holds(step.x() == 0, supports.left, component == 0) ||
         holds(step.x() == mesh.n_nodes_along_x() - 1, supports.right, component == 0) ||
         holds(step.y() == mesh.n_nodes_along_z() - 1, supports.bottom, component == 1);
}

}  // namespace

Factorization::Factorization(std::shared_ptr<const Model> model, const Supports& supports)
    : model_(std::move(model)) {
  number_unknowns(supports);
  matrix_ = assemble();
  factor_.compute(matrix_);  // S = L Lᵀ, after a renumbering that keeps L sparse
  if (factor_.info() != Eigen::Success) {
    throw FactorizationError(
        fmt::format("the stiffness of {} unknowns is not positive definite", matrix_.rows()));
  }
}

void Factorization::number_unknowns(const Supports& supports) {
  const Mesh& mesh = model_->mesh();
  numbers_.assign(2 * static_cast<std::size_t>(mesh.n_nodes()), interior);
  int next = 0;
  for (Index node = 0; node < mesh.n_nodes(); ++node) {
    if (mesh.is_interior(node)) {
      n_free_interior_ += 2;
      continue;
    }
    for (int c = 0; c < 2; ++c) {
      numbers_[static_cast<std::size_t>(2 * node + c)] =
          is_held(mesh, supports, node, c) ? held : next++;
    }
  }
}

std::vector<Index> Factorization::edge_unknowns(Index element) const {
  return select(model_->unknowns(element), model_->split().edge);
}

std::vector<Index> Factorization::interior_unknowns(Index element) const {
  return select(model_->unknowns(element), model_->split().interior);
}

// Assembles the lower triangle of S = Σ_e (K_ee − K_ei R), the condensed stiffness, on the free
// unknowns.
Factorization::Matrix Factorization::assemble() const {
  std::vector<Eigen::Triplet<double, int>> triplets;
  for (Index e = 0; e < model_->mesh().n_elements(); ++e) {
    const std::vector<Index> edge = edge_unknowns(e);
    const Eigen::MatrixXd& stiffness = model_->condensed(e).edge;
    for (std::size_t j = 0; j < edge.size(); ++j) {
      const int column = numbers_[static_cast<std::size_t>(edge[j])];
      if (column < 0) continue;
      for (std::size_t i = 0; i < edge.size(); ++i) {
        const int row = numbers_[static_cast<std::size_t>(edge[i])];
        if (row < column) continue;
        triplets.emplace_back(row, column, stiffness(static_cast<Index>(i), static_cast<Index>(j)));
      }
    }
  }
  const int n = *std::max_element(numbers_.begin(), numbers_.end()) + 1;
  Matrix matrix(n, n);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return matrix;
}

Solution Factorization::solve(const elasticity::Load& load) const {
  // Solve, then refine once, which recovers the digits lost in condensing thin elements
  const Eigen::VectorXd forces = surface_forces(model_->mesh(), model_->basis(), load);
  Eigen::VectorXd displacements = Eigen::VectorXd::Zero(forces.size());
  Eigen::VectorXd residual = forces;
  for (int step = 0; step < 2; ++step) {
    correct(residual, displacements);                            // u = u + K⁻¹ r
    residual = forces - model_->internal_forces(displacements);  // r = f − K u
  }

  // The residual on the fixed unknowns is the reaction of the supports. Elsewhere it must be
  // rounding: 1e-10 of the load here, 1e-9 in a block 1e5 times as large as its smallest element. A
  // factor that lost its digits leaves much more.
  constexpr double max_unbalanced = 1e-6;
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    if (numbers_[i] == held) residual[static_cast<Index>(i)] = 0;
  }
  const double unbalanced = residual.norm() / forces.norm();
  if (!std::isfinite(unbalanced)) {
    throw FactorizationError(
        "the solution is not a finite number: the load, the material's moduli or the size of the "
        "block are beyond the range of a double");
  }
  if (unbalanced > max_unbalanced) {
    throw FactorizationError(fmt::format(
        "the solution leaves {:.2g} of the load unbalanced: the stiffness is too ill-conditioned",
        unbalanced));
  }
  return {model_, std::move(displacements), forces};
}

// Assembles f_e − Rᵀf_i, element by element, on the condensed unknowns.
Eigen::VectorXd Factorization::condensed_forces(const Eigen::VectorXd& forces) const {
  Eigen::VectorXd condensed = Eigen::VectorXd::Zero(matrix_.rows());
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    if (numbers_[i] >= 0) condensed[numbers_[i]] = forces[static_cast<Index>(i)];
  }
  for (Index e = 0; e < model_->mesh().n_elements(); ++e) {
    const std::vector<Index> edge = edge_unknowns(e);
    const Eigen::VectorXd inner_forces = forces(interior_unknowns(e));
    const Eigen::VectorXd transferred = model_->condensed(e).recovery.transpose() * inner_forces;
    for (std::size_t k = 0; k < edge.size(); ++k) {
      const int number = numbers_[static_cast<std::size_t>(edge[k])];
      if (number >= 0) condensed[number] -= transferred[static_cast<Index>(k)];
    }
  }
  return condensed;
}

// Adds the displacements due to the residual forces: on the edges from the factor, inside from u_i
// = K_ii⁻¹ f_i − R u_e.
void Factorization::correct(const Eigen::VectorXd& residual, Eigen::VectorXd& displacements) const {
  Eigen::VectorXd correction = Eigen::VectorXd::Zero(displacements.size());
  const Eigen::VectorXd condensed = factor_.solve(condensed_forces(residual));  // u_e
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    if (numbers_[i] >= 0) correction[static_cast<Index>(i)] = condensed[numbers_[i]];
  }
  for (Index e = 0; e < model_->mesh().n_elements(); ++e) {
    const CondensedStiffness& element = model_->condensed(e);
    const std::vector<Index> inside = interior_unknowns(e);
    const Eigen::VectorXd edge = correction(edge_unknowns(e));
    const Eigen::VectorXd inner_forces = residual(inside);  // f_i
    correction(inside) = element.interior.solve(inner_forces) - element.recovery * edge;
  }
  displacements += correction;
}

}  // namespace block
