// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <complex>
#include <functional>
#include <span>
#include <vector>

#include "numerics/fourier.hpp"
#include "point_contact/element.hpp"
#include "point_contact/problem.hpp"

namespace point_contact {

/// Convolutions of fields on n1 × n2 nodes, zero-padded and continued periodically, by Fourier
/// transforms along rows and then columns. A field is a vector of n2 rows of n1 values.
///
/// Rows are transformed in pairs, as the real and imaginary parts of complex ones. Columns are
/// transformed only for wave numbers up to half the period; forward transform, multiplication and
/// inverse follow while the column is in the cache. Rows of zeros are neither stored nor
/// transformed: memory 8 n2 (period1 + 2) bytes. FFTW's own transform of a padded plane takes twice
/// as long.
class PlaneFilter {
 public:
  /// period1 ≥ n1 and period2 ≥ n2, even.
  PlaneFilter(Eigen::Index n1, Eigen::Index n2, Eigen::Index period1, Eigen::Index period2);

  /// Multiplies the column of the spectrum at wave number k1 = 0 … period1/2 along the rows, for k2
  /// = 0 … period2−1. The multiplication must also divide by period1·period2.
  using Multiplication = std::function<void(Eigen::Index k1, std::span<std::complex<double>>)>;

  /// Transforms the field, multiplies its spectrum and transforms it back. `field` and `result` may
  /// be the same vector.
  void apply(const Eigen::VectorXd& field, Eigen::VectorXd& result,
             const Multiplication& multiplication);

 private:
  void transform_rows(const Eigen::VectorXd& field);
  void filter_columns(const Multiplication& multiplication);
  void transform_rows_back(Eigen::VectorXd& result);

  Eigen::Index n1_, n2_;
  Eigen::Index n_columns_;  // period1/2 + 1
  numerics::ComplexFourier along_rows_, along_columns_;
  numerics::ComplexBuffer row_;                   // two rows, as a complex one
  std::vector<numerics::ComplexBuffer> columns_;  // some columns
  numerics::ComplexBuffer spectrum_;              // n2 rows, rounded up to even, of n_columns
};

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
