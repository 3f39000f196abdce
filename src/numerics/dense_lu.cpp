// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/dense_lu.hpp"

#include <Eigen/LU>

namespace numerics {

struct DenseLu::Factors {
  Eigen::PartialPivLU<Eigen::MatrixXd> lu;
};

DenseLu::DenseLu(const Eigen::MatrixXd& matrix)
    : factors_(std::make_unique<const Factors>(Factors{matrix.partialPivLu()})) {}
DenseLu::~DenseLu() = default;
DenseLu::DenseLu(DenseLu&&) noexcept = default;
DenseLu& DenseLu::operator=(DenseLu&&) noexcept = default;

Eigen::VectorXd DenseLu::solve(const Eigen::VectorXd& right_side) const {
  return factors_->lu.solve(right_side);
}

}  // namespace numerics
