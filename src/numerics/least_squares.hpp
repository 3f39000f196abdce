// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>
#include <vector>

#include "numerics/measured.hpp"

namespace numerics {

/// A linear model that was fitted to observations.
struct LinearLeastSquares {
  /// The coefficients with all that the observations leave open: standard uncertainties with their
  /// covariance, and bounds.
  std::vector<Measured> coefficients;
  std::vector<double> residuals;  ///< observed − fitted, one an observation
  /// χ² = Σ (residual/u)². It is to be compared with degrees_of_freedom if the observations are
  /// independent; none where they have no standard uncertainty.
  std::optional<double> chi_squared;
  int degrees_of_freedom = 0;  ///< observations less coefficients
};

/// Fits y = A c: the c that minimise Σᵢ (yᵢ − Σⱼ Aᵢⱼ cⱼ)²/uᵢ² with the standard uncertainties uᵢ of
/// the observations, or with equal weights if none has one.
///
/// c = A⁺ y is linear in y. So the law of propagation is exact, whatever the observations have in
/// common: for independent ones the covariance is (Aᵀ diag(u⁻²) A)⁻¹ (Björck, Numerical Methods for
/// Least Squares Problems, 1996, 1.1.4), and a bound on y leaves cⱼ the range Σᵢ |A⁺ⱼᵢ| boundᵢ. A⁺
/// comes from the singular values of the weighted matrix. Accuracy: rounding times the condition
/// number of that matrix, which the bounds of the coefficients include.
///
/// What the observations scatter beyond their own uncertainties is in no coefficient: without
/// standard uncertainties these have bounds alone, and whoever wants more estimates the uncertainty
/// from the residuals and fits again (numerics::mean_of does).
///
/// A has a row for each observation and a column for each coefficient. Throws InvalidQuantity for
/// fewer rows than columns, no column, another number of observations than rows, numbers that are
/// not finite, columns that depend on one another to rounding, and for observations of which some
/// have a standard uncertainty and others none.
LinearLeastSquares fit_linear(const Eigen::MatrixXd& matrix, const std::vector<Measured>& observed);

/// Numbers with a given covariance, from a fit made elsewhere. Their sources are named
/// «source 1», «source 2», …, one an eigenvector of the covariance. Another fit needs another
/// `source`, since numbers that have a name in common are correlated.
///
/// Throws InvalidQuantity for a matrix that is not square of the numbers' size, not symmetric, or
/// has an eigenvalue that is negative beyond rounding.
std::vector<Measured> correlated(const std::vector<double>& values,
                                 const Eigen::MatrixXd& covariance, std::string_view source);

}  // namespace numerics
