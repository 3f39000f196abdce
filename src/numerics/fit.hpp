// SPDX-License-Identifier: GPL-3.0-or-later
// Systems of linear equations by Eigen, and linear least squares by GSL.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace numerics {

/// Solves matrix·x = right_side by LU factors with partial pivoting. Eigen's factorisation is slow
/// to compile, so it is compiled only here.
Eigen::VectorXd solve(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right_side);

/// A linear model y = A c fitted to observations.
struct Fit {
  Eigen::VectorXd coefficients;  ///< c
  Eigen::MatrixXd covariance;    ///< of the coefficients
  Eigen::VectorXd residuals;     ///< observed − fitted
  double chi_squared;            ///< Σ (residual/u)², with u = 1 if no uncertainties are given
  int degrees_of_freedom;        ///< observations minus coefficients

  /// The standard uncertainty of a coefficient.
  double standard(Eigen::Index j) const;
};

/// Fits y = A c with equal weights: the c that minimise Σᵢ (yᵢ − Σⱼ Aᵢⱼ cⱼ)² (gsl_multifit_linear).
///
/// The covariance is s² (AᵀA)⁻¹ with s² = Σ residual²/(n − p), the scatter of n observations about
/// the fit of p coefficients; with no degrees of freedom it is infinite.
///
/// A has one row per observation and one column per coefficient. Throws InvalidQuantity if A has no
/// columns or fewer rows than columns, if the number of observations differs from the number of
/// rows, for entries that are not finite, and for columns that are linearly dependent to rounding.
Fit fit(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& observed);

/// The same with a standard uncertainty uᵢ > 0 for each observation: minimises Σᵢ (residualᵢ/uᵢ)².
/// The covariance is (Aᵀ diag(u⁻²) A)⁻¹, whatever the residuals (gsl_multifit_wlinear).
Fit fit(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& observed,
        const Eigen::VectorXd& standard);

/// The order of a power law C·n^−r.
struct PowerLaw {
  double order;           ///< r
  double order_standard;  ///< its standard uncertainty, from the scatter about the law
};

/// Fits |error| = C·n^−r by least squares on the logarithms, with equal weights. Throws
/// InvalidQuantity for fewer than three errors, lists of different lengths, n ≤ 0, and an error of
/// 0.
PowerLaw fit_power(const std::vector<double>& n, const std::vector<double>& errors);

}  // namespace numerics
