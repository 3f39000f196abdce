// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/scatter.hpp"

#include <fmt/core.h>

#include <cmath>

#include "numerics/estimate_algebra.hpp"
#include "numerics/least_squares.hpp"
#include "system/require.hpp"

namespace numerics {
namespace {

void require_count(std::string_view quantity, std::size_t n, std::size_t least) {
  if (n < least) {
    throw sys::InvalidQuantity(quantity, static_cast<double>(n), fmt::format("{} or more", least));
  }
}

// The observations, each uncertain by the standard deviation of the residuals of a fit to them.
std::vector<Measured> with_scatter(const Eigen::MatrixXd& matrix,
                                   const std::vector<Estimate>& observed, std::string_view source) {
  std::vector<Measured> values;
  for (const Estimate& y : observed) values.push_back(Measured::bounded(y));
  const LinearLeastSquares fit = fit_linear(matrix, values);
  double squares = 0;
  for (const double residual : fit.residuals) squares += residual * residual;
  const double deviation = std::sqrt(squares / fit.degrees_of_freedom);
  if (deviation == 0) return values;
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = values[i] + Measured(0, deviation, fmt::format("{}/{}", source, i + 1));
  }
  return values;
}

}  // namespace

Measured mean_of(const std::vector<Estimate>& observed, std::string_view source) {
  require_count("number of observations", observed.size(), 2);
  const Eigen::MatrixXd ones = Eigen::MatrixXd::Ones(static_cast<Eigen::Index>(observed.size()), 1);
  return fit_linear(ones, with_scatter(ones, observed, source)).coefficients[0];
}

ScatteredPower fit_scattered_power(const std::vector<double>& n,
                                   const std::vector<Estimate>& errors, std::string_view source) {
  require_count("number of errors", errors.size(), 3);
  if (n.size() != errors.size()) {
    throw sys::InvalidQuantity("number of abscissae", static_cast<double>(n.size()),
                               "the number of errors");
  }
  // ln|error| = ln C − r ln n
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(n.size()), 2);
  std::vector<Estimate> logarithms;
  for (std::size_t i = 0; i < n.size(); ++i) {
    matrix.row(static_cast<Eigen::Index>(i)) << 1, -std::log(n[i]);
    logarithms.push_back(log(abs(errors[i])));
  }
  const auto coefficients =
      fit_linear(matrix, with_scatter(matrix, logarithms, source)).coefficients;
  return {coefficients[1], exp(coefficients[0])};
}

}  // namespace numerics
