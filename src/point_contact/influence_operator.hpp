// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "point_contact/element.hpp"
#include "point_contact/plane_filter.hpp"
#include "point_contact/problem.hpp"

namespace point_contact {

/// Products with the influence coefficients T of elements on n1 × n2 nodes, in O(n log n): the
/// matrix depends only on the difference of nodes and is therefore a block of a circulant matrix of
/// twice the size each way, which the Fourier transform diagonalises.
///
/// Rounding: about 1e-16 times the greatest displacement. That is about n1 times an element's own
/// displacement, so the pressure has a rounding error of 1e-16·n1.
class InfluenceOperator {
 public:
  InfluenceOperator(Element element, Eigen::Index n1, Eigen::Index n2);

  /// Σ T φ at all nodes. `phi` and `result` may be the same vector.
  void displacements(const Eigen::VectorXd& phi, Eigen::VectorXd& result);

  /// An approximate T⁻¹: the inverse of the circulant matrix of half the size, whose eigenvalues
  /// are every other one of those above. It needs no zero padding and costs a third of a product.
  /// Opposite sides of the field become neighbours, which does no harm because the inverse decays
  /// with the cube of the distance. Symmetric and positive definite.
  void precondition(const Eigen::VectorXd& residual, Eigen::VectorXd& result);

 private:
  double eigenvalue(Eigen::Index k1, Eigen::Index k2) const {
    return eigenvalues_[static_cast<std::size_t>(k1 * period2_ + k2)];
  }

  Eigen::Index period1_, period2_;
  PlaneFilter product_, preconditioner_;
  std::vector<double> eigenvalues_;  // at k1 = 0 … period1/2, k2 = 0 … period2−1
};

}  // namespace point_contact
