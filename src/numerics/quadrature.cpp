// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/quadrature.hpp"

#include <fmt/core.h>
#include <gsl/gsl_errno.h>

#include <cmath>
#include <new>

namespace numerics {
Quadrature::Quadrature(std::size_t max_intervals)
    : max_intervals_(max_intervals), workspace_(gsl_integration_workspace_alloc(max_intervals)) {
  if (!workspace_) throw std::bad_alloc();
  [[maybe_unused]] static gsl_error_handler_t* const former =
      gsl_set_error_handler_off();  // once: not thread-safe
}

Quadrature::Outcome Quadrature::run_smooth(gsl_function* f, double a, double b,
                                           double abs_tolerance) {
  Outcome outcome{};
  auto& [value, abs_error] = outcome.result;
  std::size_t n_evaluations = 0;
  outcome.status =
      gsl_integration_qng(f, a, b, abs_tolerance, 0, &value, &abs_error, &n_evaluations);
  if (outcome.status == GSL_ETOL) {
    outcome.status = gsl_integration_qags(f, a, b, abs_tolerance, 0, max_intervals_,
                                          workspace_.get(), &value, &abs_error);
  }
  return outcome;
}

Quadrature::Outcome Quadrature::run_adaptive(gsl_function* f, double a, double b,
                                             double abs_tolerance, GaussKronrod rule) {
  Outcome outcome{};
  auto& [value, abs_error] = outcome.result;
  outcome.status =
      gsl_integration_qag(f, a, b, abs_tolerance, 0, max_intervals_, static_cast<int>(rule),
                          workspace_.get(), &value, &abs_error);
  return outcome;
}

Quadrature::Outcome Quadrature::run_principal_value(gsl_function* f, double a, double b,
                                                    double pole, double abs_tolerance) {
  Outcome outcome{};
  auto& [value, abs_error] = outcome.result;
  outcome.status = gsl_integration_qawc(f, a, b, pole, abs_tolerance, 0, max_intervals_,
                                        workspace_.get(), &value, &abs_error);
  return outcome;
}

Estimate Quadrature::checked(const Outcome& outcome, const std::exception_ptr& exception, double a,
                             double b, IntegralName name) {
  if (exception) std::rethrow_exception(exception);
  const Estimate& result = outcome.result;
  const bool is_finite = std::isfinite(result.value) && std::isfinite(result.abs_error);
  if (outcome.status == GSL_SUCCESS && is_finite) return result;
  throw QuadratureError(
      fmt::format("{} over [{}, {}] at x = {}: {} (reached {} ± {})", name.what, a, b, name.at,
                  is_finite ? gsl_strerror(outcome.status) : "the integrand is not finite",
                  result.value, result.abs_error));
}

}  // namespace numerics
