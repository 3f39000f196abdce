// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/fit.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "numerics/least_squares.hpp"
#include "system/require.hpp"

namespace block {
namespace {

using Observed = std::vector<SurfaceDisplacement>;
using numerics::Measured;

// Returns A_ik = u_k(x_i)/u_i, a row for each observation and a column for each load, on one of the
// two discretisations.
Eigen::MatrixXd relative_displacements(const std::vector<RefinedSolution>& solutions,
                                       const Solution& (RefinedSolution::*mesh)() const,
                                       const Observed& observed) {
  Eigen::MatrixXd ratios(static_cast<Index>(observed.size()), static_cast<Index>(solutions.size()));
  for (Index k = 0; k < ratios.cols(); ++k) {
    const Solution& solution = (solutions[static_cast<std::size_t>(k)].*mesh)();
    for (Index i = 0; i < ratios.rows(); ++i) {
      const SurfaceDisplacement& point = observed[static_cast<std::size_t>(i)];
      ratios(i, k) = solution.displacement(point.x, 0).y() / point.u_z.value();
    }
  }
  return ratios;
}

void require_observed(const Observed& observed, std::size_t n_loads) {
  if (n_loads == 0 || observed.size() < n_loads) {
    throw sys::InvalidQuantity("number of observed displacements",
                               static_cast<double>(observed.size()),
                               "no less than the number of loads, which is 1 or more");
  }
  for (const SurfaceDisplacement& point : observed) {
    sys::require_positive("observed displacement", point.u_z.value());
  }
}

}  // namespace

std::vector<Measured> relative(const Observed& observed) {
  std::vector<Measured> ones;
  ones.reserve(observed.size());
  for (const SurfaceDisplacement& point : observed) ones.push_back(point.u_z / point.u_z.value());
  return ones;
}

Fit fit_loads(const std::vector<RefinedSolution>& solutions, const Observed& observed) {
  require_observed(observed, solutions.size());

  // Solve the least-squares problem on both meshes
  const std::vector<Measured> ones = relative(observed);
  const numerics::LinearLeastSquares fine = numerics::fit_linear(
      relative_displacements(solutions, &RefinedSolution::fine, observed), ones);
  const numerics::LinearLeastSquares coarse = numerics::fit_linear(
      relative_displacements(solutions, &RefinedSolution::coarse, observed), ones);

  Fit fit{.factors = fine.coefficients, .residuals = {}, .solution = solutions.front()};
  std::vector<double> values;
  for (std::size_t k = 0; k < fit.factors.size(); ++k) {
    values.push_back(fine.coefficients[k].value());
    const double distance = std::abs(values[k] - coarse.coefficients[k].value());
    fit.factors[k] = fit.factors[k] + Measured::bounded({0, distance});
  }
  for (const double residual : fine.residuals) {
    fit.residuals.push_back(-residual);
    fit.max_misfit = std::max(fit.max_misfit, std::abs(residual));
  }
  fit.solution = RefinedSolution::combination(solutions, values);
  return fit;
}

Fit fit_coarse_loads(const std::vector<RefinedSolution>& solutions, const Observed& observed) {
  std::vector<RefinedSolution> coarse;
  coarse.reserve(solutions.size());
  for (const RefinedSolution& s : solutions) coarse.emplace_back(s.coarse(), s.coarse());
  return fit_loads(coarse, observed);
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

  const Measured peak = fit.factors[0];
  const Measured edge = fit.factors[1];
  const auto pressure = [p_m = peak.value(), p_e = edge.value(), falling, rising](double x) {
    return p_m * falling(x) + p_e * rising(x);
  };
  return {peak, edge, edge / peak, elasticity::distributed_load(pressure, nullptr, kinks),
          std::move(fit)};
}

}  // namespace block
