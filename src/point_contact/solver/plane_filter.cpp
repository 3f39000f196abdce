// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/plane_filter.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "point_contact/solver/grid.hpp"

namespace point_contact {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::VectorXd;
using numerics::ComplexBuffer;

// About the operations of a transform.
double cost_of(std::size_t size) {
  const auto n = static_cast<double>(size);
  return 5 * n * std::log2(n);
}

}  // namespace

PlaneFilter::PlaneFilter(Index n1, Index n2, Index period1, Index period2, bool is_staggered)
    : n1_(n1),
      n2_(n2),
      n_columns_(period1 / 2 + 1),
      along_rows_(size_of(period1)),
      along_columns_(size_of(period2)),
      spectrum_(size_of((n2 + n2 % 2) * n_columns_)) {
  if (!is_staggered) return;
  for (Index k = 0; k < n_columns_; ++k) {
    const double turn = static_cast<double>(k) / static_cast<double>(period1);
    half_shift_.push_back(std::polar(1.0, -std::numbers::pi * turn));
  }
}

void PlaneFilter::apply(const VectorXd& field, VectorXd& result,
                        const Multiplication& multiplication, const RowTeam& team) {
  transform_rows(field, team);
  filter_columns(multiplication, team);
  transform_rows_back(result, team);
}

// z = a + ib of two rows has the spectrum Z = A + iB, and as a and b are real,
//   A_k = (Z_k + Z*_{−k})/2,  B_k = (Z_k − Z*_{−k})/(2i).
void PlaneFilter::transform_rows(const VectorXd& field, const RowTeam& team) {
  const Index n_pairs = (n2_ + 1) / 2;
  team.for_stretches(n_pairs, cost_of(along_rows_.size()), [&](Index begin, Index end, int) {
    const ComplexBuffer z(along_rows_.size());
    const std::size_t period = z.size();
    for (Index pair = begin; pair < end; ++pair) {
      const double* a = field.data() + 2 * pair * n1_;
      const double* b = 2 * pair + 1 < n2_ ? a + n1_ : nullptr;
      for (Index i = 0; i < n1_; ++i) z[size_of(i)] = {a[i], b ? b[i] : 0};
      std::fill(z.data() + n1_, z.data() + period, Complex());
      along_rows_.forward(z);

      Complex* first = spectrum_.data() + 2 * pair * n_columns_;
      Complex* second = first + n_columns_;
      for (std::size_t k = 0; k < size_of(n_columns_); ++k) {
        const Complex here = z[k];
        const Complex mirrored = std::conj(z[k == 0 ? 0 : period - k]);
        const Complex difference = here - mirrored;
        first[k] = 0.5 * (here + mirrored);
        second[k] = {0.5 * difference.imag(), -0.5 * difference.real()};
      }
      for (std::size_t k = 0; k < half_shift_.size(); ++k) second[k] *= half_shift_[k];
    }
  });
}

// Eight columns at a time, so that whole lines of the cache are read and written.
void PlaneFilter::filter_columns(const Multiplication& multiplication, const RowTeam& team) {
  constexpr Index width = 8;
  const Index n_blocks = (n_columns_ + width - 1) / width;
  const double cost = 2 * width * cost_of(along_columns_.size());
  team.for_stretches(n_blocks, cost, [&](Index begin, Index end, int) {
    std::vector<ComplexBuffer> columns;
    for (Index c = 0; c < width; ++c) columns.emplace_back(along_columns_.size());
    for (Index block = begin; block < end; ++block) {
      const Index from = block * width;
      const Index n = std::min(width, n_columns_ - from);
      for (Index j = 0; j < n2_; ++j) {
        const Complex* row = spectrum_.data() + j * n_columns_ + from;
        for (Index c = 0; c < n; ++c) columns[size_of(c)][size_of(j)] = row[c];
      }
      for (Index c = 0; c < n; ++c) {
        const ComplexBuffer& column = columns[size_of(c)];
        std::fill(column.data() + n2_, column.data() + column.size(), Complex());
        along_columns_.forward(column);
        multiplication(from + c, column.numbers());
        along_columns_.backward(column);
      }
      for (Index j = 0; j < n2_; ++j) {
        Complex* row = spectrum_.data() + j * n_columns_ + from;
        for (Index c = 0; c < n; ++c) row[c] = columns[size_of(c)][size_of(j)];
      }
    }
  });
}

// Z_k = A_k + iB_k and Z_{−k} = A*_k + iB*_k.
void PlaneFilter::transform_rows_back(VectorXd& result, const RowTeam& team) const {
  result.resize(n1_ * n2_);
  const Index n_pairs = (n2_ + 1) / 2;
  team.for_stretches(n_pairs, cost_of(along_rows_.size()), [&](Index begin, Index end, int) {
    const ComplexBuffer z(along_rows_.size());
    const std::size_t period = z.size();
    for (Index pair = begin; pair < end; ++pair) {
      const Complex* first = spectrum_.data() + 2 * pair * n_columns_;
      const Complex* second = first + n_columns_;
      for (std::size_t k = 0; k < size_of(n_columns_); ++k) {
        const Complex& a = first[k];
        const Complex b = half_shift_.empty() ? second[k] : second[k] * std::conj(half_shift_[k]);
        if (k > 0) z[period - k] = {a.real() + b.imag(), b.real() - a.imag()};
        z[k] = {a.real() - b.imag(), a.imag() + b.real()};
      }
      along_rows_.backward(z);

      double* a = result.data() + 2 * pair * n1_;
      for (Index i = 0; i < n1_; ++i) a[i] = z[size_of(i)].real();
      if (2 * pair + 1 == n2_) continue;
      for (Index i = 0; i < n1_; ++i) a[n1_ + i] = z[size_of(i)].imag();
    }
  });
}

}  // namespace point_contact
