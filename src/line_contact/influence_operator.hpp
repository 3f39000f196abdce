// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "line_contact/element.hpp"
#include "numerics/fourier.hpp"

namespace line_contact {

/// Products with the Toeplitz matrix of influence coefficients, T(i−j), i, j = 0 … n−1, in O(n log
/// n): the matrix is a block of a circulant matrix, which the Fourier transform diagonalises.
class InfluenceOperator {
 public:
  InfluenceOperator(Element element, Eigen::Index n);

  /// Σ_j T(i−j) φ_j. The rounding error is that of the greatest term, about 1e-15 Σφ.
  void potentials(const Eigen::VectorXd& phi, Eigen::VectorXd& result);

  /// Σ_j [T(i+1−j) − T(i−j)] φ_j, i = 0 … n−2: differences of the above with n times less rounding
  /// than subtracting would leave. It is eq. (2) on the grid.
  void differences(const Eigen::VectorXd& phi, Eigen::VectorXd& result);

  /// An approximate −T⁻¹: the inverse of the circulant matrix, close to |q|/π at wave number q,
  /// without its mean. Symmetric and positive semi-definite.
  void precondition(const Eigen::VectorXd& residual, Eigen::VectorXd& result);

 private:
  void load(const Eigen::VectorXd& values);
  void store(Eigen::VectorXd& result, Eigen::Index n);

  Eigen::Index n_;
  numerics::RealFourier fourier_;
  std::vector<double> eigenvalues_;                        // of the circulant matrix, over its size
  std::vector<std::complex<double>> difference_spectrum_;  // of T(k+1) − T(k), over the size
};

/// The differences of the potential between neighbours of all n_nodes nodes of a grid, i = 0 …
/// n_nodes−2, due to values φ on the nodes from `first` on.
Eigen::VectorXd differences_over_grid(Element element, const Eigen::VectorXd& phi,
                                      Eigen::Index first, Eigen::Index n_nodes);

}  // namespace line_contact
