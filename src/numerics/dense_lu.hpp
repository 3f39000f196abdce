// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>

namespace numerics {

/// LU factors of a square matrix with partial pivoting, by Eigen. The wrapper exists because the
/// factorisation is slow to compile: it is compiled once.
class DenseLu {
 public:
  explicit DenseLu(const Eigen::MatrixXd& matrix);
  ~DenseLu();
  DenseLu(DenseLu&&) noexcept;
  DenseLu& operator=(DenseLu&&) noexcept;

  /// Solves matrix·x = right_side.
  Eigen::VectorXd solve(const Eigen::VectorXd& right_side) const;

 private:
  struct Factors;
  std::unique_ptr<const Factors> factors_;
};

}  // namespace numerics
