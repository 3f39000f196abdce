// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/factorization.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "block/element_stiffness.hpp"

namespace block {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::vector<Index> select(const std::vector<Index>& numbers, const std::vector<int>& which) {
  std::vector<Index> selected;
  selected.reserve(which.size());
  for (const int local : which) selected.push_back(numbers[static_cast<std::size_t>(local)]);
  return selected;
}

}  // namespace

Factorization::Factorization(std::shared_ptr<const Model> model, const Supports& supports)
    : model_(std::move(model)), supports_(supports) {
  require_no_rigid_motion(supports);
  const auto start = Clock::now();
  number_unknowns();
  matrix_ = assemble();
  assembly_seconds_ = seconds_since(start);

  const auto assembled = Clock::now();
  factor_.compute(matrix_);  // S = L D Lᵀ, after a renumbering that keeps L sparse
  factorization_seconds_ = seconds_since(assembled);
  if (factor_.info() != Eigen::Success) {
    throw FactorizationError(
        fmt::format("the stiffness of {} unknowns is not positive definite", matrix_.rows()));
  }
}

Index Factorization::n_unknowns() const {
  return matrix_.rows() + n_free_interior_;
}

bool Factorization::is_held(Index node, int component) const {
  const Mesh& mesh = model_->mesh();
  const Eigen::Vector2<Index> step = mesh.grid_position(node);
  const auto holds = [](bool on_side, Support support, bool is_normal) {
    return on_side && (support == Support::clamped || (support == Support::roller && is_normal));
  };
  return holds(step.x() == 0, supports_.left, component == 0) ||
         holds(step.x() == mesh.n_nodes_along_x() - 1, supports_.right, component == 0) ||
         holds(step.y() == 0, supports_.top, component == 1) ||
         holds(step.y() == mesh.n_nodes_along_z() - 1, supports_.bottom, component == 1);
}

void Factorization::number_unknowns() {
  const Mesh& mesh = model_->mesh();
  numbers_.assign(2 * static_cast<std::size_t>(mesh.n_nodes()), -1);
  int next = 0;
  for (Index node = 0; node < mesh.n_nodes(); ++node) {
    if (mesh.is_interior(node)) {
      n_free_interior_ += 2;
      continue;
    }
    for (int c = 0; c < 2; ++c) {
      if (!is_held(node, c)) numbers_[static_cast<std::size_t>(2 * node + c)] = next++;
    }
  }
}

std::vector<Index> Factorization::edge_unknowns(Index element) const {
  return select(model_->unknowns(element), model_->split().edge);
}

std::vector<Index> Factorization::interior_unknowns(Index element) const {
  return select(model_->unknowns(element), model_->split().interior);
}

// Adds up S = Σ_e (K_ee − K_ei R), the condensed stiffness of the elements, on the unknowns that
// are not held; its lower triangle.
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
  int n = 0;
  for (const int number : numbers_) n = std::max(n, number + 1);
  Matrix matrix(n, n);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return matrix;
}

Solution Factorization::solve(const elasticity::Load& load) const {
  return solve(Loading{.surface = load});
}

Solution Factorization::solve(const Loading& loading) const {
  // Turn what acts into nodal forces f
  const Mesh& mesh = model_->mesh();
  Eigen::VectorXd forces = surface_forces(mesh, model_->basis(), loading.surface);
  if (loading.body_force) forces += body_forces(mesh, model_->basis(), loading.body_force);

  // Solve, and refine once: it wins back the digits that the condensation of thin elements lost
  Eigen::VectorXd displacements = held_displacements(loading.prescribed_displacement);
  Eigen::VectorXd residual = forces;  // r = f − K u
  if (loading.prescribed_displacement) residual -= model_->internal_forces(displacements);
  const double scale = residual.norm();
  for (int step = 0; step < 2; ++step) {
    correct(residual, displacements);                            // u = u + K⁻¹ r
    residual = forces - model_->internal_forces(displacements);  // r = f − K u
  }

  // What is left on the held unknowns is what the supports carry; elsewhere only rounding may be
  // left: 1e-10 of the load here, 1e-9 in a block 1e5 times as large as its smallest element. A
  // factor that lost its digits leaves a good part of the load.
  constexpr double max_unbalanced = 1e-6;
  Eigen::VectorXd support_forces = -held_part(residual);
  const double unbalanced = (residual + support_forces).norm();
  if (!std::isfinite(unbalanced / scale)) {
    throw FactorizationError(
        "the solution is not a finite number: the sizes of the load, of the material's moduli or "
        "of the block are beyond the range of a double");
  }
  if (unbalanced > max_unbalanced * scale) {
    throw FactorizationError(fmt::format(
        "the solution leaves {:.2g} of the load unbalanced: the stiffness is too ill-conditioned",
        unbalanced / scale));
  }
  return {model_, std::move(displacements), std::move(forces), std::move(support_forces)};
}

Eigen::VectorXd Factorization::held_displacements(const Field& prescribed) const {
  const Mesh& mesh = model_->mesh();
  Eigen::VectorXd displacements = Eigen::VectorXd::Zero(2 * mesh.n_nodes());
  if (!prescribed) return displacements;
  for (Index node = 0; node < mesh.n_nodes(); ++node) {
    const Eigen::Vector2d position = mesh.position(node);
    displacements.segment<2>(2 * node) = prescribed(position.x(), position.y());
  }
  return held_part(displacements);
}

// Returns the vector with all but the held unknowns set to zero.
Eigen::VectorXd Factorization::held_part(const Eigen::VectorXd& vector) const {
  Eigen::VectorXd held = Eigen::VectorXd::Zero(vector.size());
  for (Index node = 0; node < model_->mesh().n_nodes(); ++node) {
    for (int c = 0; c < 2; ++c) {
      if (is_held(node, c)) held[2 * node + c] = vector[2 * node + c];
    }
  }
  return held;
}

// Adds up f_e − Rᵀf_i, element by element, on the condensed unknowns.
Eigen::VectorXd Factorization::condensed_forces(const Eigen::VectorXd& forces) const {
  Eigen::VectorXd condensed = Eigen::VectorXd::Zero(matrix_.rows());
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    if (numbers_[i] >= 0) condensed[numbers_[i]] = forces[static_cast<Index>(i)];
  }
  if (model_->split().interior.empty()) return condensed;
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

// Adds the displacements that the residual forces cause: on the edges by the factor, inside by
// u_i = K_ii⁻¹ f_i − R u_e.
void Factorization::correct(const Eigen::VectorXd& residual, Eigen::VectorXd& displacements) const {
  Eigen::VectorXd correction = Eigen::VectorXd::Zero(displacements.size());
  const Eigen::VectorXd condensed = factor_.solve(condensed_forces(residual));  // u_e
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    if (numbers_[i] >= 0) correction[static_cast<Index>(i)] = condensed[numbers_[i]];
  }
  for (Index e = 0; e < model_->mesh().n_elements(); ++e) {
    const std::vector<Index> interior = interior_unknowns(e);
    if (interior.empty()) break;
    const CondensedStiffness& element = model_->condensed(e);
    const Eigen::VectorXd edge = correction(edge_unknowns(e));
    const Eigen::VectorXd inner_forces = residual(interior);  // f_i
    correction(interior) = element.interior.solve(inner_forces) - element.recovery * edge;
  }
  displacements += correction;
}

}  // namespace block
