// SPDX-License-Identifier: GPL-3.0-or-later
// Linear least squares, by GSL.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace numerics {

/// A linear model y = A c that was fitted to observations.
struct Fit {
  Eigen::VectorXd coefficients;  ///< c
  Eigen::MatrixXd covariance;    ///< of the coefficients
  Eigen::VectorXd residuals;     ///< observed − fitted
  double chi_squared;            ///< Σ (residual/u)², u = 1 where no uncertainties are given
  int degrees_of_freedom;        ///< observations less coefficients

  /// The standard uncertainty of a coefficient.
  double standard(Eigen::Index j) const;

  /// The covariance of two coefficients over both standard uncertainties.
  double correlation(Eigen::Index j, Eigen::Index k) const;
};

/// Fits y = A c with equal weights: the c that minimise Σᵢ (yᵢ − Σⱼ Aᵢⱼ cⱼ)² (gsl_multifit_linear).
///
/// The covariance is s² (AᵀA)⁻¹ with s² = Σ residual²/(n − p) from the scatter of the n
/// observations about the p columns; without a degree of freedom it is infinite.
///
/// A has a row for each observation and a column for each coefficient. Throws InvalidQuantity for
/// no column, fewer rows than columns, another number of observations than rows, entries that are
/// not finite, and columns that depend on one another to rounding.
Fit fit(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& observed);

/// The same where each observation has a standard uncertainty uᵢ > 0: minimises Σᵢ (residualᵢ/uᵢ)²
/// with the covariance (Aᵀ diag(u⁻²) A)⁻¹, whatever the residuals (gsl_multifit_wlinear).
Fit fit(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& observed,
        const Eigen::VectorXd& standard);

/// A power law C·n^−r.
struct PowerLaw {
  double order;            ///< r
  double order_standard;   ///< its standard uncertainty, from the scatter about the law
  double factor;           ///< C, in the unit of the errors
  double factor_standard;  ///< its standard uncertainty
};

/// Fits |error| = C·n^−r by least squares for the logarithms, all with the same weight. Throws
/// InvalidQuantity for fewer than three errors, lists of different lengths, and an n or an error
/// that is not > 0 in magnitude.
PowerLaw fit_power(const std::vector<double>& n, const std::vector<double>& errors);

}  // namespace numerics
