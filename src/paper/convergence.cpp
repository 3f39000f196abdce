// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/convergence.hpp"

#include <gsl/gsl_fit.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "contact/fft_solver.hpp"

namespace paper {

contact::Solution solve_cylinders(const parameters::ContactCase& c, const contact::Hertz& hertz,
                                  contact::Element element, long n_nodes) {
  constexpr double tolerance = 1e-12;
  return contact::solve_by_fft(
      {c.cylinders.profile(), c.cylinders.contact_modulus(),
       contact::grid_of_width(cylinder_domain * hertz.half_width(), n_nodes), element},
      c.line_load, tolerance);
}

HertzErrors errors_against(const contact::Hertz& hertz, const contact::Solution& solution) {
  constexpr double inner_part = 0.9;
  const double a = hertz.half_width();
  double squares = 0;
  double largest = 0;
  int n_inside = 0;
  for (Eigen::Index i = 0; i < solution.grid.n_nodes; ++i) {
    const double x = solution.grid.x(i);
    const double error = (solution.pressure[i] - hertz.pressure(x)) / hertz.peak_pressure();
    largest = std::max(largest, std::abs(error));
    if (std::abs(x) > inner_part * a) continue;
    squares += error * error;
    ++n_inside;
  }
  const contact::Region region = solution.regions().front();
  return {a / solution.grid.spacing,
          std::sqrt(squares / n_inside),
          largest,
          solution.peak_pressure() / hertz.peak_pressure() - 1,
          solution.half_width_by_count() / a - 1,
          (region.end - region.begin) / 2 / a - 1,
          solution.half_width() / a - 1};
}

ConvergenceStudy convergence_study(const parameters::ContactCase& c, const contact::Hertz& hertz,
                                   contact::Element element) {
  constexpr int n_grids = 80;
  constexpr double coarsest = 33;
  constexpr double finest = 50 * coarsest;
  ConvergenceStudy study;
  for (int k = 0; k < n_grids; ++k) {
    const double share = k / (n_grids - 1.0);
    const long n_nodes = std::lround(coarsest * std::pow(finest / coarsest, share));
    const HertzErrors e = errors_against(hertz, solve_cylinders(c, hertz, element, n_nodes));
    study.elements.push_back(e.elements);
    study.inside.push_back(e.inside);
    study.largest.push_back(e.largest);
    study.peak.push_back(e.peak);
    study.count.push_back(e.half_width_count);
    study.extrapolated.push_back(e.half_width_extrapolated);
    study.moment.push_back(e.half_width_moment);
  }
  return study;
}

namespace {

// How much a straight line's slope moves when each of the ordinates may move by as much as given.
double slope_error(const std::vector<double>& x, const std::vector<double>& bounds) {
  const auto n = static_cast<double>(x.size());
  const double mean = std::accumulate(x.begin(), x.end(), 0.0) / n;
  double squares = 0;
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    squares += (x[i] - mean) * (x[i] - mean);
    sum += std::abs(x[i] - mean) * bounds[i];
  }
  return sum / squares;
}

}  // namespace

Power fitted_power(const std::vector<double>& n, const std::vector<double>& errors,
                   const std::vector<double>& bounds) {
  const std::size_t size_of_bin = n.size() < 20 ? 1 : 10;
  std::vector<double> log_n;
  std::vector<double> log_error;
  std::vector<double> log_bound;
  for (std::size_t begin = 0; begin + size_of_bin <= n.size(); begin += size_of_bin) {
    double sum_of_logs = 0;
    double squares = 0;
    double squares_of_bounds = 0;
    for (std::size_t i = begin; i < begin + size_of_bin; ++i) {
      sum_of_logs += std::log(n[i]);
      squares += errors[i] * errors[i];
      squares_of_bounds += bounds.empty() ? 0 : bounds[i] * bounds[i];
    }
    const auto size = static_cast<double>(size_of_bin);
    log_n.push_back(sum_of_logs / size);
    log_error.push_back(std::log(squares / size) / 2);
    // By as much as its bound a root mean square can fall; its logarithm falls more than it rises,
    // without limit if the error is no more than its bound, which is left at 36 or e⁻³⁶ = ε.
    log_bound.push_back(-std::log1p(-std::min(1 - std::numeric_limits<double>::epsilon(),
                                              std::sqrt(squares_of_bounds / squares))));
  }
  double intercept, slope, cov00, cov01, cov11, residual;
  gsl_fit_linear(log_n.data(), 1, log_error.data(), 1, log_n.size(), &intercept, &slope, &cov00,
                 &cov01, &cov11, &residual);
  return {-slope, std::exp(intercept), slope_error(log_n, log_bound)};
}

}  // namespace paper
