// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/power_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numerics/estimate_algebra.hpp"
#include "numerics/least_squares.hpp"
#include "system/require.hpp"

namespace numerics {
namespace {

constexpr std::size_t bin_size = 10;

struct Logarithms {
  std::vector<double> n, error, bound;
};

void require_lengths(std::size_t n, std::size_t errors, std::size_t bounds) {
  if (errors < 2) {
    throw sys::InvalidQuantity("number of errors", static_cast<double>(errors), "2 or more");
  }
  for (const std::size_t length : {n, bounds}) {
    if (length != errors) {
      throw sys::InvalidQuantity("number of abscissae or bounds", static_cast<double>(length),
                                 "the number of errors");
    }
  }
}

// The mean of ln n, ln √⟨error²⟩ and a bound of the latter for each bin.
Logarithms logarithms(const std::vector<double>& n, const std::vector<double>& errors,
                      const std::vector<double>& bounds) {
  const std::size_t size = errors.size() < 2 * bin_size ? 1 : bin_size;
  const auto count = static_cast<double>(size);
  Logarithms logs;
  for (std::size_t begin = 0; begin + size <= errors.size(); begin += size) {
    double sum_of_logs = 0;
    double squares = 0;
    double squares_of_bounds = 0;
    for (std::size_t i = begin; i < begin + size; ++i) {
      sum_of_logs += std::log(n[i]);
      squares += errors[i] * errors[i];
      squares_of_bounds += bounds.empty() ? 0 : bounds[i] * bounds[i];
    }
    logs.n.push_back(sum_of_logs / count);
    logs.error.push_back(std::log(squares / count) / 2);
    // A root mean square can fall by its bound at most. Its logarithm falls by more than it rises,
    // and without limit where the bound is the whole error; the limit set here is −ln ε = 36.
    const double share = std::sqrt(squares_of_bounds / squares);
    logs.bound.push_back(-std::log1p(-std::min(1 - std::numeric_limits<double>::epsilon(), share)));
  }
  return logs;
}

}  // namespace

PowerFit fit_power(const std::vector<double>& n, const std::vector<double>& errors,
                   const std::vector<double>& bounds) {
  require_lengths(n.size(), errors.size(), bounds.empty() ? errors.size() : bounds.size());
  const Logarithms logs = logarithms(n, errors, bounds);
  // ln|error| = ln C − r ln n
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(logs.n.size()), 2);
  std::vector<Measured> observed;
  for (std::size_t i = 0; i < logs.n.size(); ++i) {
    matrix.row(static_cast<Eigen::Index>(i)) << 1, -logs.n[i];
    observed.push_back(Measured::bounded({logs.error[i], logs.bound[i]}));
  }
  const LinearLeastSquares fit = fit_linear(matrix, observed);
  return {fit.coefficients[1].bounded(), exp(fit.coefficients[0].bounded())};
}

}  // namespace numerics
