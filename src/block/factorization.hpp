// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <memory>
#include <vector>

#include "block/model.hpp"
#include "block/rectangle.hpp"
#include "block/solution.hpp"
#include "elasticity/loads.hpp"

namespace block {

/// The stiffness of a supported block, factorised once for any number of loads.
///
/// The unknowns are the displacements on the element edges that no support fixes; the Cholesky
/// factor LLᵀ is Eigen's, in approximate minimum degree order.
class Factorization {
 public:
  /// Assembles and factorises. Throws FactorizationError if the matrix is not positive definite in
  /// floating point, such as for supports that leave a rigid motion.
  Factorization(std::shared_ptr<const Model> model, const Supports& supports);

  /// The displacement under a load on the top. Throws InvalidQuantity for a load outside the block
  /// or a concentrated one, FactorizationError if the solution does not satisfy its equations.
  Solution solve(const elasticity::Load& load) const;

  const std::shared_ptr<const Model>& model() const { return model_; }

  /// The number of displacement components that no support fixes.
  Index n_unknowns() const { return matrix_.rows() + n_free_interior_; }

 private:
  using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

  void number_unknowns(const Supports& supports);
  Matrix assemble() const;
  std::vector<Index> edge_unknowns(Index element) const;
  std::vector<Index> interior_unknowns(Index element) const;
  Eigen::VectorXd condensed_forces(const Eigen::VectorXd& forces) const;
  void correct(const Eigen::VectorXd& residual, Eigen::VectorXd& displacements) const;

  std::shared_ptr<const Model> model_;
  std::vector<int> numbers_;  // number of each condensed unknown, or one of the following
  static constexpr int held = -1, interior = -2;
  Index n_free_interior_ = 0;
  Matrix matrix_;
  Eigen::SimplicialLLT<Matrix, Eigen::Lower> factor_;
};

}  // namespace block
