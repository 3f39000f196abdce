// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/fit.hpp"

#include <gsl/gsl_multifit.h>

#include <cmath>
#include <memory>
#include <utility>

#include "system/require.hpp"

namespace block {
namespace {

using Observed = std::vector<SurfaceDisplacement>;
using Ratios = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

struct FreeWorkspace {
  void operator()(gsl_multifit_linear_workspace* w) const { gsl_multifit_linear_free(w); }
};

// Returns A_ik = u_k(x_i)/u_i, a row for each observation and a column for each load, on one of the
// two discretisations.
Ratios relative_displacements(const std::vector<RefinedSolution>& solutions,
                              const Solution& (RefinedSolution::*mesh)() const,
                              const Observed& observed) {
  Ratios ratios(static_cast<Index>(observed.size()), static_cast<Index>(solutions.size()));
  for (Index k = 0; k < ratios.cols(); ++k) {
    const Solution& solution = (solutions[static_cast<std::size_t>(k)].*mesh)();
    for (Index i = 0; i < ratios.rows(); ++i) {
      const SurfaceDisplacement& point = observed[static_cast<std::size_t>(i)];
      ratios(i, k) = solution.displacement(point.x, 0).y() / point.u_z;
    }
  }
  return ratios;
}

// Returns the factors f that make the sum of the squared relative misfits, Σ_i (Σ_k A_ik f_k − 1)²,
// least; A are the ratios. GSL does it by singular values, because Eigen's QR would take the
// compiler ten seconds.
Eigen::VectorXd least_squares(const Ratios& ratios) {
  const auto n_rows = static_cast<std::size_t>(ratios.rows());
  const auto n_columns = static_cast<std::size_t>(ratios.cols());
  const std::vector<double> ones(n_rows, 1);
  Eigen::VectorXd factors(ratios.cols());
  std::vector<double> covariances(n_columns * n_columns);
  const auto matrix = gsl_matrix_const_view_array(ratios.data(), n_rows, n_columns);
  const auto right_side = gsl_vector_const_view_array(ones.data(), n_rows);
  auto result = gsl_vector_view_array(factors.data(), n_columns);
  auto covariance = gsl_matrix_view_array(covariances.data(), n_columns, n_columns);
  double sum_of_squares = 0;
  const std::unique_ptr<gsl_multifit_linear_workspace, FreeWorkspace> workspace(
      gsl_multifit_linear_alloc(n_rows, n_columns));
  gsl_multifit_linear(&matrix.matrix, &right_side.vector, &result.vector, &covariance.matrix,
                      &sum_of_squares, workspace.get());
  return factors;
}

void require_observed(const Observed& observed, std::size_t n_loads) {
  if (n_loads == 0 || observed.size() < n_loads) {
    throw sys::InvalidQuantity("number of observed displacements",
                               static_cast<double>(observed.size()),
                               "no less than the number of loads, which is 1 or more");
  }
  for (const SurfaceDisplacement& point : observed) {
    sys::require_positive("observed displacement", point.u_z);
  }
}

// Returns A f − 1.
Eigen::VectorXd misfits(const Ratios& ratios, const Eigen::VectorXd& factors) {
  return ratios * factors - Eigen::VectorXd::Ones(ratios.rows());
}

}  // namespace

Fit fit_loads(const std::vector<RefinedSolution>& solutions, const Observed& observed) {
  require_observed(observed, solutions.size());

  // Solve the least-squares problem on both meshes
  const Ratios ratios = relative_displacements(solutions, &RefinedSolution::fine, observed);
  const Eigen::VectorXd fine = least_squares(ratios);
  const Eigen::VectorXd coarse =
      least_squares(relative_displacements(solutions, &RefinedSolution::coarse, observed));

  std::vector<numerics::Estimate> factors;
  for (Index k = 0; k < fine.size(); ++k) {
    factors.push_back({fine[k], std::abs(fine[k] - coarse[k])});
  }
  const Eigen::VectorXd residuals = misfits(ratios, fine);
  return {factors,
          {residuals.begin(), residuals.end()},
          residuals.cwiseAbs().maxCoeff(),
          residuals.norm() / std::sqrt(static_cast<double>(residuals.size())),
          RefinedSolution::combination(solutions, {fine.begin(), fine.end()})};
}

LinearFit fit_linear_load(const SupportedBlock& block, double half_width,
                          const Observed& observed) {
  const double a = sys::require_positive("half_width", half_width);
  const auto falling = [a](double x) { return 1 - std::abs(x) / a; };
  const auto rising = [a](double x) { return std::abs(x) / a; };
  const std::vector<double> kinks{-a, 0, a};
  Fit fit = fit_loads({block.solve(elasticity::distributed_load(falling, nullptr, kinks)),
                       block.solve(elasticity::distributed_load(rising, nullptr, kinks))},
                      observed);

  // The edge fraction is the quotient of the two factors, and its error has those of both
  const numerics::Estimate peak = fit.factors[0];
  const numerics::Estimate edge = fit.factors[1];
  const double fraction = edge.value / peak.value;
  const double fraction_error =
      (edge.abs_error + std::abs(fraction) * peak.abs_error) / std::abs(peak.value);
  const auto pressure = [=](double x) { return peak.value * falling(x) + edge.value * rising(x); };
  return {peak,
          {fraction, fraction_error},
          elasticity::distributed_load(pressure, nullptr, kinks),
          std::move(fit)};
}

}  // namespace block
