// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <memory>
#include <vector>

#include "block/model.hpp"
#include "block/nodal_forces.hpp"
#include "block/rectangle.hpp"
#include "block/solution.hpp"
#include "elasticity/load.hpp"

namespace block {

/// All that may act on a supported block; what is left empty is zero.
struct Loading {
  elasticity::Load surface = {};
  Field body_force = {};               ///< force per volume
  Field prescribed_displacement = {};  ///< of the held sides, where a support fixes the component
};

/// The stiffness of a supported block, factorised once for any number of loads.
///
/// The unknowns are the displacements on the element edges that no support fixes; the Cholesky
/// factor LLᵀ is Eigen's, in approximate minimum degree order.
class Factorization {
 public:
  /// Assembles and factorises. Throws InvalidQuantity for supports that leave a rigid motion, and
  /// FactorizationError where the matrix is not positive definite in floating point.
  Factorization(std::shared_ptr<const Model> model, const Supports& supports);

  /// The displacement under a load on the top. Throws InvalidQuantity for a load outside the block
  /// or concentrated, FactorizationError where the solution fails to satisfy its equations.
  Solution solve(const elasticity::Load& load) const;

  /// The same with body forces and prescribed displacements.
  Solution solve(const Loading& loading) const;

  const Supports& supports() const { return supports_; }
  const std::shared_ptr<const Model>& model() const { return model_; }

  /// Free displacement components: all of them, and those left after condensation.
  Index n_unknowns() const;
  Index n_condensed_unknowns() const { return matrix_.rows(); }

  /// Seconds of wall time: of assembly, and of factorisation.
  double assembly_seconds() const { return assembly_seconds_; }
  double factorization_seconds() const { return factorization_seconds_; }

 private:
  using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

  void number_unknowns();
  Matrix assemble() const;
  bool is_held(Index node, int component) const;
  std::vector<Index> edge_unknowns(Index element) const;
  std::vector<Index> interior_unknowns(Index element) const;
  Eigen::VectorXd held_displacements(const Field& prescribed) const;
  Eigen::VectorXd held_part(const Eigen::VectorXd& vector) const;
  Eigen::VectorXd condensed_forces(const Eigen::VectorXd& forces) const;
  void correct(const Eigen::VectorXd& residual, Eigen::VectorXd& displacements) const;

  std::shared_ptr<const Model> model_;
  Supports supports_;
  std::vector<int> numbers_;  // of the condensed unknowns, −1 where held or interior
  Index n_free_interior_ = 0;
  Matrix matrix_;
  Eigen::SimplicialLLT<Matrix, Eigen::Lower> factor_;
  double assembly_seconds_ = 0;
  double factorization_seconds_ = 0;
};

}  // namespace block
