// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/influence_operator.hpp"

#include <algorithm>
#include <complex>
#include <cstddef>
#include <cstdlib>
#include <span>

#include "point_contact/problem.hpp"

namespace point_contact {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::VectorXd;
using numerics::ComplexBuffer;
using numerics::ComplexFourier;

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

namespace {

// Twice a convenient size, so that the half is convenient too.
Index period_for(Index n) {
  return 2 * static_cast<Index>(numerics::convenient_fourier_size(size_of(n)));
}

// The coefficients T(k1, k2) at |k1| ≤ half1 and 0 ≤ k2 ≤ half2. An element is symmetric in x and
// y, T(k1, k2) = T(k2, k1) = T(−k2, −k1), so only half of them need computing.
class Coefficients {
 public:
  Coefficients(Element element, Index half1, Index half2)
      : half1_(half1), rows_(2 * half1 + 1, half2 + 1) {
    for (Index k2 = 0; k2 <= half2; ++k2) {
      for (Index k1 = -half1; k1 <= half1; ++k1) {
        const bool is_known = std::abs(k1) < k2 && k2 <= half1;
        rows_(half1 + k1, k2) =
            is_known ? (*this)(k1 < 0 ? -k2 : k2, std::abs(k1))
                     : influence_coefficient(element,
                                             {static_cast<double>(k1), static_cast<double>(k2)});
      }
    }
  }

  double operator()(Index k1, Index k2) const { return rows_(half1_ + k1, k2); }

 private:
  Index half1_;
  Eigen::MatrixXd rows_;
};

// The transforms of the rows k2 = 0 … period2/2 of coefficients, at k1 = 0 … period1/2 each. A lag
// of half the period equals its opposite: the mean of the two keeps the matrix symmetric.
ComplexBuffer transformed_rows(Element element, Index period1, Index period2) {
  const Index half1 = period1 / 2;
  const Index half2 = period2 / 2;
  const Coefficients coefficient(element, half1, half2);
  const ComplexFourier fourier(size_of(period1));
  const ComplexBuffer row(size_of(period1));
  ComplexBuffer spectrum(size_of((half1 + 1) * (half2 + 1)));
  for (Index k2 = 0; k2 <= half2; ++k2) {
    const auto mean = [&](Index k1) { return (coefficient(k1, k2) + coefficient(-k1, k2)) / 2; };
    for (Index k = 1; k < half1; ++k) {
      row[size_of(k)] = k2 == half2 ? mean(k) : coefficient(k, k2);
      row[size_of(period1 - k)] = k2 == half2 ? mean(k) : coefficient(-k, k2);
    }
    row[0] = coefficient(0, k2);
    row[size_of(half1)] = mean(half1);
    fourier.forward(row);
    std::copy(row.data(), row.data() + half1 + 1, spectrum.data() + k2 * (half1 + 1));
  }
  return spectrum;
}

// As T(−d) = T(d), the spectra of the rows of lags −k2 and k2 are conjugate, and the transform of a
// column is real.
std::vector<double> eigenvalues_of(Element element, Index period1, Index period2) {
  const ComplexBuffer rows = transformed_rows(element, period1, period2);
  const Index n_columns = period1 / 2 + 1;
  const ComplexFourier fourier(size_of(period2));
  const ComplexBuffer column(size_of(period2));
  std::vector<double> eigenvalues(size_of(n_columns * period2));
  for (Index k1 = 0; k1 < n_columns; ++k1) {
    for (Index k2 = 0; k2 <= period2 / 2; ++k2) {
      const Complex& value = rows[size_of(k2 * n_columns + k1)];
      if (k2 > 0) column[size_of(period2 - k2)] = std::conj(value);
      column[size_of(k2)] = value;
    }
    fourier.forward(column);
    for (Index k2 = 0; k2 < period2; ++k2) {
      eigenvalues[size_of(k1 * period2 + k2)] = column[size_of(k2)].real();
    }
  }
  return eigenvalues;
}

}  // namespace

InfluenceOperator::InfluenceOperator(Element element, Index n1, Index n2)
    : period1_(period_for(n1)),
      period2_(period_for(n2)),
      product_(n1, n2, period1_, period2_),
      preconditioner_(n1, n2, period1_ / 2, period2_ / 2),
      eigenvalues_(eigenvalues_of(element, period1_, period2_)) {}

void InfluenceOperator::displacements(const VectorXd& phi, VectorXd& result) {
  const double scale = 1 / (static_cast<double>(period1_) * static_cast<double>(period2_));
  product_.apply(phi, result, [&](Index k1, std::span<Complex> column) {
    for (Index k2 = 0; k2 < period2_; ++k2) column[size_of(k2)] *= scale * eigenvalue(k1, k2);
  });
}

void InfluenceOperator::precondition(const VectorXd& residual, VectorXd& result) {
  const double size = static_cast<double>(period1_) * static_cast<double>(period2_) / 4;
  preconditioner_.apply(residual, result, [&](Index k1, std::span<Complex> column) {
    for (Index k2 = 0; k2 < period2_ / 2; ++k2) {
      column[size_of(k2)] *= 1 / (size * eigenvalue(2 * k1, 2 * k2));
    }
  });
}

}  // namespace point_contact
