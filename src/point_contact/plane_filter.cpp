// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/plane_filter.hpp"

#include <algorithm>
#include <cstddef>

#include "point_contact/problem.hpp"

namespace point_contact {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::VectorXd;
using numerics::ComplexBuffer;

// Columns processed together, so that whole cache lines are read and written.
constexpr Index n_at_once = 8;

}  // namespace

PlaneFilter::PlaneFilter(Index n1, Index n2, Index period1, Index period2)
    : n1_(n1),
      n2_(n2),
      n_columns_(period1 / 2 + 1),
      along_rows_(size_of(period1)),
      along_columns_(size_of(period2)),
      row_(size_of(period1)),
      spectrum_(size_of((n2 + n2 % 2) * n_columns_)) {
  for (Index c = 0; c < n_at_once; ++c) columns_.emplace_back(size_of(period2));
}

void PlaneFilter::apply(const VectorXd& field, VectorXd& result,
                        const Multiplication& multiplication) {
  transform_rows(field);
  filter_columns(multiplication);
  transform_rows_back(result);
}

// z = a + ib of two rows has the spectrum Z = A + iB, and as a and b are real,
//   A_k = (Z_k + Z*_{−k})/2,  B_k = (Z_k − Z*_{−k})/(2i).
void PlaneFilter::transform_rows(const VectorXd& field) {
  const std::size_t period = row_.size();
  for (Index j = 0; j < n2_; j += 2) {
    const double* a = field.data() + j * n1_;
    const double* b = j + 1 < n2_ ? a + n1_ : nullptr;
    for (Index i = 0; i < n1_; ++i) row_[size_of(i)] = {a[i], b ? b[i] : 0};
    std::fill(row_.data() + n1_, row_.data() + period, Complex());
    along_rows_.forward(row_);

    const Complex* z = row_.data();
    Complex* first = spectrum_.data() + j * n_columns_;
    Complex* second = first + n_columns_;
    first[0] = z[0].real();
    second[0] = z[0].imag();
    for (std::size_t k = 1; k < size_of(n_columns_); ++k) {
      const Complex here = z[k];
      const Complex mirrored = z[period - k];
      first[k] = {0.5 * (here.real() + mirrored.real()), 0.5 * (here.imag() - mirrored.imag())};
      second[k] = {0.5 * (here.imag() + mirrored.imag()), 0.5 * (mirrored.real() - here.real())};
    }
  }
}

void PlaneFilter::filter_columns(const Multiplication& multiplication) {
  for (Index from = 0; from < n_columns_; from += n_at_once) {
    const Index n = std::min(n_at_once, n_columns_ - from);
    for (Index j = 0; j < n2_; ++j) {
      const Complex* row = spectrum_.data() + j * n_columns_ + from;
      for (Index c = 0; c < n; ++c) columns_[size_of(c)][size_of(j)] = row[c];
    }
    for (Index c = 0; c < n; ++c) {
      const ComplexBuffer& column = columns_[size_of(c)];
      std::fill(column.data() + n2_, column.data() + column.size(), Complex());
      along_columns_.forward(column);
      multiplication(from + c, column.numbers());
      along_columns_.backward(column);
    }
    for (Index j = 0; j < n2_; ++j) {
      Complex* row = spectrum_.data() + j * n_columns_ + from;
      for (Index c = 0; c < n; ++c) row[c] = columns_[size_of(c)][size_of(j)];
    }
  }
}

// Z_k = A_k + iB_k and Z_{−k} = A*_k + iB*_k.
void PlaneFilter::transform_rows_back(VectorXd& result) {
  result.resize(n1_ * n2_);
  const std::size_t period = row_.size();
  for (Index j = 0; j < n2_; j += 2) {
    const Complex* first = spectrum_.data() + j * n_columns_;
    const Complex* second = first + n_columns_;
    Complex* z = row_.data();
    z[0] = {first[0].real() - second[0].imag(), first[0].imag() + second[0].real()};
    for (std::size_t k = 1; k < size_of(n_columns_); ++k) {
      const Complex a = first[k];
      const Complex b = second[k];
      z[period - k] = {a.real() + b.imag(), b.real() - a.imag()};
      z[k] = {a.real() - b.imag(), a.imag() + b.real()};
    }
    along_rows_.backward(row_);

    double* a = result.data() + j * n1_;
    for (Index i = 0; i < n1_; ++i) a[i] = row_[size_of(i)].real();
    if (j + 1 == n2_) continue;
    for (Index i = 0; i < n1_; ++i) a[n1_ + i] = row_[size_of(i)].imag();
  }
}

}  // namespace point_contact
