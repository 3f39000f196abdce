// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <complex>
#include <functional>
#include <span>
#include <vector>

#include "numerics/fourier.hpp"

namespace point_contact {

/// Convolutions of fields on n1 × n2 nodes, continued periodically with zeros in between, by
/// Fourier transforms along rows and then columns. A field is a vector of n2 rows of n1 values.
///
/// Rows are transformed two at a time, as the real and imaginary parts of complex ones; of columns
/// only those of wave numbers up to half the period, and both directions with the multiplication in
/// between while the column is in the cache. Rows and columns of zeros are neither stored nor
/// transformed: memory 8 n2 (period1 + 2) bytes. FFTW's own transform of a padded plane takes twice
/// as long.
class PlaneFilter {
 public:
  /// period1 ≥ n1 and period2 ≥ n2, even.
  PlaneFilter(Eigen::Index n1, Eigen::Index n2, Eigen::Index period1, Eigen::Index period2);

  /// Multiplies a column of the spectrum, that of the wave number k1 = 0 … period1/2 along the
  /// rows, at k2 = 0 … period2−1. To return to the field, the spectrum has to be divided by
  /// period1·period2 besides.
  using Multiplication = std::function<void(Eigen::Index k1, std::span<std::complex<double>>)>;

  /// result = field, transformed, multiplied, transformed back. The two may be the same.
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
  numerics::ComplexBuffer spectrum_;              // n2 rows, an even number of them, of n_columns
};

}  // namespace point_contact
