// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/least_squares.hpp"

#include <fmt/core.h>
#include <gsl/gsl_eigen.h>
#include <gsl/gsl_linalg.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "system/require.hpp"

namespace numerics {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

void require_number(std::string_view quantity, Index n, bool is_allowed, std::string_view allowed) {
  if (!is_allowed) throw sys::InvalidQuantity(quantity, static_cast<double>(n), allowed);
}

void require_finite(std::string_view quantity, const MatrixXd& matrix) {
  for (const double entry : matrix.reshaped()) sys::require_finite(quantity, entry);
}

gsl_matrix_view view(RowMajor& matrix) {
  return gsl_matrix_view_array(matrix.data(), static_cast<std::size_t>(matrix.rows()),
                               static_cast<std::size_t>(matrix.cols()));
}

gsl_vector_view view(VectorXd& vector) {
  return gsl_vector_view_array(vector.data(), static_cast<std::size_t>(vector.size()));
}

// 1/u of each observation, or ones if no observation has a standard uncertainty.
VectorXd weights_of(const std::vector<Measured>& observed) {
  VectorXd weights(static_cast<Index>(observed.size()));
  std::transform(observed.begin(), observed.end(), weights.begin(),
                 [](const Measured& y) { return y.standard(); });
  const Index n_uncertain = (weights.array() > 0).count();
  if (n_uncertain == 0) return VectorXd::Ones(weights.size());
  require_number("observations with a standard uncertainty", n_uncertain,
                 n_uncertain == weights.size(), "none or all");
  return weights.cwiseInverse();
}

// With W A = U S Vᵀ the pseudo-inverse of W A is V S⁻¹ Uᵀ, and A⁺ = V S⁻¹ Uᵀ W.
MatrixXd pseudo_inverse(const MatrixXd& matrix, const VectorXd& weights) {
  RowMajor left = weights.asDiagonal() * matrix;
  RowMajor right(matrix.cols(), matrix.cols());
  VectorXd singular(matrix.cols()), workspace(matrix.cols());
  auto u = view(left), v = view(right);
  auto s = view(singular), work = view(workspace);
  gsl_linalg_SV_decomp(&u.matrix, &v.matrix, &s.vector, &work.vector);
  const double ratio = singular.minCoeff() / singular.maxCoeff();
  const double least = static_cast<double>(matrix.rows()) * std::numeric_limits<double>::epsilon();
  if (!(ratio > least)) {
    throw sys::InvalidQuantity(
        "least singular value of a fit's columns over the greatest", ratio,
        fmt::format("more than {}: the columns depend on one another", least));
  }
  return right * singular.cwiseInverse().asDiagonal() * left.transpose() * weights.asDiagonal();
}

// What the rounding of A⁺ does to each coefficient. The singular values found are those of a matrix
// that is wrong by δ = m ε ‖W A‖. With X = (W A)⁺ and the residuals r = y − A c, the coefficient cⱼ
// is then wrong by ‖Xⱼ‖ ‖c‖ δ + ‖(X Xᵀ)ⱼ‖ ‖W r‖ δ to first order (Wedin; Björck, Numerical Methods
// for Least Squares Problems, 1996, 1.4.3).
VectorXd rounding_of(const MatrixXd& matrix, const MatrixXd& inverse, const VectorXd& weights,
                     const VectorXd& y) {
  const MatrixXd x = inverse * weights.cwiseInverse().asDiagonal();
  const VectorXd c = inverse * y;
  const double delta = static_cast<double>(y.size()) * std::numeric_limits<double>::epsilon() *
                       (weights.asDiagonal() * matrix).norm();
  const double residuals = weights.cwiseProduct(y - matrix * c).norm();
  return delta * (c.norm() * x.rowwise().norm() + residuals * (x * x.transpose()).rowwise().norm());
}

}  // namespace

LinearLeastSquares fit_linear(const MatrixXd& matrix, const std::vector<Measured>& observed) {
  const auto n_observed = static_cast<Index>(observed.size());
  require_number("number of coefficients of a fit", matrix.cols(), matrix.cols() > 0, "1 or more");
  require_number("number of observations", n_observed,
                 n_observed == matrix.rows() && n_observed >= matrix.cols(),
                 "that of the rows of the matrix, and no less than the number of coefficients");
  require_finite("entry of the matrix of a fit", matrix);
  const VectorXd weights = weights_of(observed);
  const MatrixXd inverse = pseudo_inverse(matrix, weights);
  VectorXd y(n_observed);
  std::transform(observed.begin(), observed.end(), y.begin(),
                 [](const Measured& number) { return number.value(); });
  const VectorXd rounding = rounding_of(matrix, inverse, weights, y);
  if (!rounding.allFinite()) {
    const double weighted = (weights.asDiagonal() * matrix).cwiseAbs().maxCoeff();
    throw sys::InvalidQuantity("greatest observation or weighted entry of a fit",
                               std::max(y.cwiseAbs().maxCoeff(), weighted),
                               "smaller, as squares of such numbers overflow");
  }

  LinearLeastSquares fit;
  fit.degrees_of_freedom = static_cast<int>(matrix.rows() - matrix.cols());
  VectorXd values(matrix.cols());
  for (Index j = 0; j < matrix.cols(); ++j) {
    Measured coefficient = Measured::bounded({0, rounding[j]});
    for (Index i = 0; i < matrix.rows(); ++i) {
      coefficient = coefficient + inverse(j, i) * observed[static_cast<std::size_t>(i)];
    }
    values[j] = coefficient.value();
    fit.coefficients.push_back(std::move(coefficient));
  }
  const VectorXd fitted = matrix * values;
  if (observed.front().standard() > 0) fit.chi_squared = 0;
  for (Index i = 0; i < matrix.rows(); ++i) {
    const double residual = y[i] - fitted[i];
    fit.residuals.push_back(residual);
    if (fit.chi_squared) *fit.chi_squared += std::pow(residual * weights[i], 2);
  }
  return fit;
}

// With C = Q diag(λ) Qᵀ the numbers cⱼ + Σₖ Qⱼₖ √λₖ ξₖ, ξₖ independent of variance one, have the
// covariance C.
std::vector<Measured> correlated(const std::vector<double>& values, const MatrixXd& covariance,
                                 std::string_view source) {
  const auto n = static_cast<Index>(values.size());
  require_number("number of rows of a covariance", covariance.rows(),
                 covariance.rows() == n && covariance.cols() == n && n > 0,
                 "that of its columns and of the numbers, 1 or more");
  require_finite("entry of a covariance", covariance);
  const double scale = covariance.cwiseAbs().maxCoeff();
  const double rounding =
      static_cast<double>(n) * 16 * std::numeric_limits<double>::epsilon() * scale;
  const double skew = (covariance - covariance.transpose()).cwiseAbs().maxCoeff();
  if (skew > rounding) {
    throw sys::InvalidQuantity("difference of a covariance from its transpose", skew, "0");
  }

  RowMajor matrix = covariance, vectors(n, n);
  VectorXd eigenvalues(n);
  auto c = view(matrix), q = view(vectors);
  auto lambda = view(eigenvalues);
  const std::unique_ptr<gsl_eigen_symmv_workspace, decltype(&gsl_eigen_symmv_free)> workspace(
      gsl_eigen_symmv_alloc(values.size()), &gsl_eigen_symmv_free);
  gsl_eigen_symmv(&c.matrix, &lambda.vector, &q.matrix, workspace.get());
  if (eigenvalues.minCoeff() < -rounding) {
    throw sys::InvalidQuantity("least eigenvalue of a covariance", eigenvalues.minCoeff(), ">= 0");
  }

  std::vector<Measured> numbers(values.begin(), values.end());
  for (Index k = 0; k < n; ++k) {
    const Measured spread(0, std::sqrt(std::max(eigenvalues[k], 0.0)),
                          fmt::format("{} {}", source, k + 1));
    for (Index j = 0; j < n; ++j) {
      auto& number = numbers[static_cast<std::size_t>(j)];
      number = number + vectors(j, k) * spread;
    }
  }
  return numbers;
}

}  // namespace numerics
