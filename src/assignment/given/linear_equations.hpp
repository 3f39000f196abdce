// SPDX-License-Identifier: GPL-3.0-or-later
// Given to students, so that the factorisation, which takes seconds to compile, is compiled once.
#pragma once

#include <Eigen/Core>

namespace exercise {

/// The x with matrix·x = right_side, by Gaussian elimination with partial pivoting.
Eigen::VectorXd solve_linear_equations(const Eigen::MatrixXd& matrix,
                                       const Eigen::VectorXd& right_side);

}  // namespace exercise
