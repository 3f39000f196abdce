// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/influence_operator.hpp"

#include <algorithm>
#include <complex>
#include <cstddef>
#include <numbers>
#include <span>

#include "point_contact/solver/grid.hpp"

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

// The elements on one grid, by the lag between two nodes: k1 along the rows, k2 between them. In
// staggered rows k1 is measured from straight above, and is ½, 3/2, … where k2 is odd.
struct Lags {
  const ElementPotential& element;
  bool is_staggered;

  bool has_halves(Index k2) const { return is_staggered && k2 % 2 != 0; }
  double operator()(double k1, Index k2) const {
    const auto rows = static_cast<double>(k2);
    return element(element.node(is_staggered ? k1 - rows / 2 : k1, rows));
  }
};

// The coefficients at the lags k1 = 0, ±1, … in one row of the circulant matrix, at the lag k2. A
// lag of half the period is both that and its opposite: their mean keeps the matrix symmetric.
void fill_row(const Lags& lags, Index period2, Index k2, std::span<double> row) {
  const auto n = static_cast<Index>(row.size());
  const Index half = n / 2;
  const bool has_halves = lags.has_halves(k2);
  const auto at = [&](Index k1) {
    return lags(static_cast<double>(k1) + (has_halves ? 0.5 : 0), k2);
  };
  for (Index k = 0; k < half; ++k) row[size_of(k)] = at(k);
  for (Index k = 1; k < half; ++k) row[size_of(n - k)] = at(-k);
  row[size_of(half)] = has_halves ? at(-half) : (at(half) + at(-half)) / 2;
  if (2 * k2 != period2) return;
  // the opposite of the lag at k, counted in whole periods
  const auto opposite = [&](Index k) { return size_of(has_halves ? n - 1 - k : n - k); };
  for (Index k = has_halves ? 0 : 1; k < half; ++k) {
    const double mean = (row[size_of(k)] + row[opposite(k)]) / 2;
    row[size_of(k)] = row[opposite(k)] = mean;
  }
}

// The transforms of the rows k2 = 0 … period2/2, at k1 = 0 … period1/2 each.
ComplexBuffer transformed_rows(const Lags& lags, Index period1, Index period2,
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
      fill_row(lags, period2, k2, row);
      std::copy(row.begin(), row.end(), z.data());
      fourier.forward(z);
      Complex* transformed = spectrum.data() + k2 * n_columns;
      std::copy(z.data(), z.data() + n_columns, transformed);
      if (!lags.has_halves(k2)) continue;
      for (Index k1 = 0; k1 < n_columns; ++k1) {
        const double turn = static_cast<double>(k1) / static_cast<double>(period1);
        transformed[k1] *= std::polar(1.0, -std::numbers::pi * turn);
      }
    }
  });
  return spectrum;
}

// As T(−d) = T(d), the row of lag −k2 has the conjugate spectrum of that of k2, and the transform
// of a column is real.
std::vector<double> eigenvalues_of(const Lags& lags, Index period1, Index period2,
                                   const RowTeam& team) {
  const ComplexBuffer rows = transformed_rows(lags, period1, period2, team);
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

InfluenceOperator::InfluenceOperator(const ElementPotential& element, const Grid& grid,
                                     const RowTeam& team)
    : n1_(grid.n1),
      n2_(grid.n2),
      period1_(period_for(grid.n1)),
      period2_(period_for(grid.n2)),
      team_(team),
      product_(n1_, n2_, period1_, period2_, grid.is_staggered),
      preconditioner_(n1_, n2_, period1_ / 2, period2_ / 2, grid.is_staggered),
      eigenvalues_(eigenvalues_of(Lags{element, grid.is_staggered}, period1_, period2_, team)) {}

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
