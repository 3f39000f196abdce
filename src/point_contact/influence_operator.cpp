// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/influence_operator.hpp"

#include <algorithm>
#include <complex>
#include <cstddef>
#include <cstdlib>
#include <span>

namespace point_contact {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::VectorXd;
using numerics::ComplexBuffer;
using numerics::ComplexFourier;

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
