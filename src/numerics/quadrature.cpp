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

Estimate Quadrature::run(Rule rule, gsl_function* f, const Interval& interval, IntegralName name) {
  const auto [a, b, abs_tolerance, parameter] = interval;
  Estimate result;
  auto& [value, abs_error] = result;
  std::size_t n_evaluations = 0;
  gsl_integration_workspace* workspace = workspace_.get();
  int status = GSL_SUCCESS;
  switch (rule) {
    case Rule::smooth:
      status = gsl_integration_qng(f, a, b, abs_tolerance, 0, &value, &abs_error, &n_evaluations);
      if (status != GSL_ETOL) break;
      status = gsl_integration_qags(f, a, b, abs_tolerance, 0, max_intervals_, workspace, &value,
                                    &abs_error);
      break;
    case Rule::adaptive:
      status = gsl_integration_qag(f, a, b, abs_tolerance, 0, max_intervals_,
                                   static_cast<int>(parameter), workspace, &value, &abs_error);
      break;
    case Rule::principal_value:
      status = gsl_integration_qawc(f, a, b, parameter, abs_tolerance, 0, max_intervals_, workspace,
                                    &value, &abs_error);
      break;
  }
  // If rounding stops the rule short of the tolerance, the estimate still bounds the error.
  constexpr double too_far_off = 1000;
  const bool is_finite = std::isfinite(value) && std::isfinite(abs_error);
  if (is_finite && (status == GSL_SUCCESS || abs_error <= too_far_off * abs_tolerance)) {
    return result;
  }
  throw QuadratureError(fmt::format(
      "{} over [{}, {}] at x = {}: {} (reached {} ± {})", name.what, a, b, name.at,
      is_finite ? gsl_strerror(status) : "the integrand is not finite", value, abs_error));
}

}  // namespace numerics
