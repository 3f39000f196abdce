// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <complex>
#include <functional>
#include <span>
#include <vector>

#include "numerics/fourier.hpp"

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

}  // namespace point_contact
