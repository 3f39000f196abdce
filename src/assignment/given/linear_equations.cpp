// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/LU>

#include "assignment/given/student_functions.hpp"

namespace exercise {

std::vector<double> solve_linear_equations(const std::vector<std::vector<double>>& matrix,
                                           const std::vector<double>& right_side) {
  const auto n = static_cast<Eigen::Index>(matrix.size());
  Eigen::MatrixXd entries(n, n);
  for (Eigen::Index row = 0; row < n; ++row) {
    entries.row(row) =
        Eigen::Map<const Eigen::RowVectorXd>(matrix[static_cast<std::size_t>(row)].data(), n);
  }
  const Eigen::VectorXd x =
      entries.partialPivLu().solve(Eigen::Map<const Eigen::VectorXd>(right_side.data(), n));
  return {x.begin(), x.end()};
}

}  // namespace exercise
