// SPDX-License-Identifier: GPL-3.0-or-later
// Students call this function, so they need not learn a library. This header is part of the
// handout.
#pragma once

#include <cstddef>
#include <vector>

namespace exercise {

/// A square matrix with n rows and columns, initially zero.
class Matrix {
 public:
  explicit Matrix(std::size_t n) : n_(n), entries_(n * n) {}

  std::size_t size() const { return n_; }
  const std::vector<double>& entries() const { return entries_; }  ///< row by row
  double& operator()(std::size_t row, std::size_t column) { return entries_[row * n_ + column]; }
  double operator()(std::size_t row, std::size_t column) const {
    return entries_[row * n_ + column];
  }

 private:
  std::size_t n_;
  std::vector<double> entries_;
};

/// Returns the x that solves matrix·x = right_side, by Gaussian elimination with partial pivoting.
std::vector<double> solve_linear_equations(const Matrix& matrix,
                                           const std::vector<double>& right_side);

}  // namespace exercise
