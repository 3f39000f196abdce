// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>

namespace numerics {

/// Eigen's LU factors of a square matrix, with partial pivoting. Here so that the factorisation,
/// which takes long to compile, is compiled once.
class DenseLu {
 public:
  explicit DenseLu(const Eigen::MatrixXd& matrix);
  ~DenseLu();
  DenseLu(DenseLu&&) noexcept;
  DenseLu& operator=(DenseLu&&) noexcept;

  /// x with matrix·x = right_side.
  Eigen::VectorXd solve(const Eigen::VectorXd& right_side) const;

 private:
  struct Factors;
  std::unique_ptr<const Factors> factors_;
};

}  // namespace numerics
