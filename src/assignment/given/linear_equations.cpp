// SPDX-License-Identifier: GPL-3.0-or-later
#include "assignment/given/linear_equations.hpp"

#include <Eigen/LU>

namespace exercise {

Eigen::VectorXd solve_linear_equations(const Eigen::MatrixXd& matrix,
                                       const Eigen::VectorXd& right_side) {
  return matrix.partialPivLu().solve(right_side);
}

}  // namespace exercise
