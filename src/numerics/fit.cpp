// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/fit.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <memory>
#include <string_view>

#include "system/require.hpp"

namespace numerics {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

gsl_matrix_view view(RowMajor& matrix) {
  return gsl_matrix_view_array(matrix.data(), static_cast<std::size_t>(matrix.rows()),
                               static_cast<std::size_t>(matrix.cols()));
}

gsl_vector_view view(VectorXd& vector) {
  return gsl_vector_view_array(vector.data(), static_cast<std::size_t>(vector.size()));
}

void require_count(std::string_view quantity, Index n, bool is_allowed, std::string_view allowed) {
  if (!is_allowed) throw sys::InvalidQuantity(quantity, static_cast<double>(n), allowed);
}

void require_finite(std::string_view quantity, const MatrixXd& entries) {
  for (const double entry : entries.reshaped()) sys::require_finite(quantity, entry);
}

// Fits with the weights w = u⁻², or with equal weights if the list is empty.
Fit weighted_fit(RowMajor matrix, VectorXd observed, VectorXd weights) {
  const Index n = matrix.rows();
  const Index p = matrix.cols();
  require_count("number of coefficients of a fit", p, p > 0, "1 or more");
  require_count("number of observations", observed.size(), observed.size() == n && n >= p,
                "the number of rows, and no less than the number of coefficients");
  require_finite("entry of the matrix of a fit", matrix);
  require_finite("observation", observed);

  Fit result{VectorXd(p), MatrixXd(p, p), VectorXd(n), 0, static_cast<int>(n - p)};
  RowMajor covariance(p, p);
  auto A = view(matrix), C = view(covariance);
  auto y = view(observed), w = view(weights), c = view(result.coefficients),
       r = view(result.residuals);
  const std::unique_ptr<gsl_multifit_linear_workspace, decltype(&gsl_multifit_linear_free)>
      workspace(gsl_multifit_linear_alloc(static_cast<std::size_t>(n), static_cast<std::size_t>(p)),
                gsl_multifit_linear_free);
  const double negligible = static_cast<double>(n) * std::numeric_limits<double>::epsilon();
  std::size_t rank = 0;
  if (weights.size() > 0) {
    gsl_multifit_wlinear_tsvd(&A.matrix, &w.vector, &y.vector, negligible, &c.vector, &C.matrix,
                              &result.chi_squared, &rank, workspace.get());
  } else {
    gsl_multifit_linear_tsvd(&A.matrix, &y.vector, negligible, &c.vector, &C.matrix,
                             &result.chi_squared, &rank, workspace.get());
  }
  require_count("number of independent columns of a fit", static_cast<Index>(rank),
                static_cast<Index>(rank) == p, "the number of its coefficients");
  gsl_multifit_linear_residuals(&A.matrix, &y.vector, &c.vector, &r.vector);
  result.covariance = covariance;
  return result;
}

}  // namespace

VectorXd solve(const MatrixXd& matrix, const VectorXd& right_side) {
  return matrix.partialPivLu().solve(right_side);
}

double Fit::standard(Index j) const {
  return std::sqrt(covariance(j, j));
}

Fit fit(const MatrixXd& matrix, const VectorXd& observed) {
  Fit result = weighted_fit(matrix, observed, {});
  if (result.degrees_of_freedom == 0) {
    result.covariance.setConstant(std::numeric_limits<double>::infinity());
  }
  return result;
}

Fit fit(const MatrixXd& matrix, const VectorXd& observed, const VectorXd& standard) {
  require_count("number of standard uncertainties", standard.size(),
                standard.size() == observed.size(), "the number of observations");
  for (const double u : standard) sys::require_positive("standard uncertainty", u);
  return weighted_fit(matrix, observed, standard.array().square().inverse());
}

// ln|error| = ln C − r ln n
PowerLaw fit_power(const std::vector<double>& n, const std::vector<double>& errors) {
  const auto count = static_cast<Index>(errors.size());
  require_count("number of errors", count, count >= 3, "3 or more");
  require_count("number of abscissae", static_cast<Index>(n.size()), n.size() == errors.size(),
                "the number of errors");
  MatrixXd matrix(count, 2);
  VectorXd logarithms(count);
  for (Index i = 0; i < count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double abscissa = sys::require_positive("abscissa", n[at]);
    matrix.row(i) << 1, -std::log(abscissa);
    logarithms[i] = std::log(sys::require_positive("magnitude of an error", std::abs(errors[at])));
  }
  const Fit found = fit(matrix, logarithms);
  return {found.coefficients[1], found.standard(1)};
}

}  // namespace numerics
