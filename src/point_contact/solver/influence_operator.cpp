// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/influence_operator.hpp"

#include <algorithm>
#include <complex>
#include <cstddef>
#include <span>
#include "point_contact/solver/size_of.hpp"

namespace point_contact {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::VectorXd;
using numerics::ComplexBuffer;
using numerics::ComplexFourier;

// Twice a convenient size, so that half of it is one too.
Index period_for(Index n) {
  return 2 * static_cast<Index>(numerics::convenient_fourier_size(size_of(n)));
}

// The coefficients at the lags k1 = 0, ±1, … in one row of the circulant matrix, at the lag k2. A
// lag of half the period is both that and its opposite: their mean keeps the matrix symmetric.
void fill_row(const ElementPotential& element, Index period2, Index k2, std::span<double> row) {
  const auto n = static_cast<Index>(row.size());
  const Index half = n / 2;
  const auto at = [&](Index k1) {
    return element(element.node(static_cast<double>(k1), static_cast<double>(k2)));
  };
  for (Index k = 0; k < half; ++k) row[size_of(k)] = at(k);
  for (Index k = 1; k < half; ++k) row[size_of(n - k)] = at(-k);
  row[size_of(half)] = (at(half) + at(-half)) / 2;
  if (2 * k2 != period2) return;
  for (Index k = 1; k < half; ++k) {
    const double mean = (row[size_of(k)] + row[size_of(n - k)]) / 2;
    row[size_of(k)] = row[size_of(n - k)] = mean;
  }
}

// The transforms of the rows k2 = 0 … period2/2, at k1 = 0 … period1/2 each.
ComplexBuffer transformed_rows(const ElementPotential& element, Index period1, Index period2,
                               const RowTeam& team) {
  const Index n_columns = period1 / 2 + 1;
  const Index n_rows = period2 / 2 + 1;
  const ComplexFourier fourier(size_of(period1));
  ComplexBuffer spectrum(size_of(n_columns * n_rows));
  constexpr double cost_of_coefficient = 100;
  const double cost = cost_of_coefficient * static_cast<double>(period1);
  team.for_stretches(n_rows, cost, [&](Index begin, Index end, int) {
    std::vector<double> row(size_of(period1));
    const ComplexBuffer z(size_of(period1));
    for (Index k2 = begin; k2 < end; ++k2) {
      fill_row(element, period2, k2, row);
      std::copy(row.begin(), row.end(), z.data());
      fourier.forward(z);
      std::copy(z.data(), z.data() + n_columns, spectrum.data() + k2 * n_columns);
    }
  });
  return spectrum;
}

// As T(−d) = T(d), the row of lag −k2 has the conjugate spectrum of that of k2, and the transform
// of a column is real.
std::vector<double> eigenvalues_of(const ElementPotential& element, Index period1, Index period2,
                                   const RowTeam& team) {
  const ComplexBuffer rows = transformed_rows(element, period1, period2, team);
  const Index n_columns = period1 / 2 + 1;
  const ComplexFourier fourier(size_of(period2));
  std::vector<double> eigenvalues(size_of(n_columns * period2));
  team.for_stretches(n_columns, 5 * 12 * static_cast<double>(period2),
                     [&](Index begin, Index end, int) {
                       const ComplexBuffer z(size_of(period2));
                       for (Index k1 = begin; k1 < end; ++k1) {
                         for (Index k2 = 0; k2 <= period2 / 2; ++k2) {
                           const Complex& value = rows[size_of(k2 * n_columns + k1)];
                           if (k2 > 0) z[size_of(period2 - k2)] = std::conj(value);
                           z[size_of(k2)] = value;
                         }
                         fourier.forward(z);
                         double* column = eigenvalues.data() + k1 * period2;
                         for (Index k2 = 0; k2 < period2; ++k2) column[k2] = z[size_of(k2)].real();
                       }
                     });
  return eigenvalues;
}

}  // namespace

InfluenceOperator::InfluenceOperator(const ElementPotential& element, Index n1, Index n2,
                                     const RowTeam& team)
    : n1_(n1),
      n2_(n2),
      period1_(period_for(n1)),
      period2_(period_for(n2)),
      team_(team),
      product_(n1, n2, period1_, period2_),
      preconditioner_(n1, n2, period1_ / 2, period2_ / 2),
      eigenvalues_(eigenvalues_of(element, period1_, period2_, team)) {}

void InfluenceOperator::displacements(const VectorXd& phi, VectorXd& result) {
  const double scale = 1 / (static_cast<double>(period1_) * static_cast<double>(period2_));
  const auto multiply = [&](Index k1, std::span<Complex> column) {
    for (Index k2 = 0; k2 < period2_; ++k2) column[size_of(k2)] *= scale * eigenvalue(k1, k2);
  };
  product_.apply(phi, result, multiply, team_);
}

void InfluenceOperator::precondition(const VectorXd& residual, VectorXd& result) {
  const double size = static_cast<double>(period1_) * static_cast<double>(period2_) / 4;
  const auto divide = [&](Index k1, std::span<Complex> column) {
    for (Index k2 = 0; k2 < period2_ / 2; ++k2) {
      column[size_of(k2)] *= 1 / (size * eigenvalue(2 * k1, 2 * k2));
    }
  };
  preconditioner_.apply(residual, result, divide, team_);
}

double InfluenceOperator::bytes(Index n1, Index n2) {
  const auto period1 = static_cast<double>(period_for(n1));
  const auto period2 = static_cast<double>(period_for(n2));
  // the two filters, the eigenvalues, and what these are computed from
  return 8 * static_cast<double>(n2) * 1.5 * period1 + 4 * period1 * period2 +
         4 * period1 * period2;
}

}  // namespace point_contact
