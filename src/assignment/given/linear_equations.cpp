// SPDX-License-Identifier: GPL-3.0-or-later
#include "assignment/given/linear_equations.hpp"

#include <Eigen/LU>

namespace exercise {

std::vector<double> solve_linear_equations(const Matrix& matrix,
                                           const std::vector<double>& right_side) {
  const auto n = static_cast<Eigen::Index>(matrix.size());
  const Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>
      entries(matrix.entries().data(), n, n);
  const Eigen::VectorXd x =
      entries.partialPivLu().solve(Eigen::Map<const Eigen::VectorXd>(right_side.data(), n));
  return {x.begin(), x.end()};
}

}  // namespace exercise
