// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gsl/gsl_integration.h>

#include <cstddef>
#include <exception>
#include <limits>
#include <memory>
#include <string_view>

#include "numerics/estimate.hpp"
#include "system/error.hpp"

namespace numerics {

/// A quadrature that did not reach its tolerance. what() names the integral, the point and GSL's
/// reason.
class QuadratureError : public sys::ComputationError {
 public:
  using ComputationError::ComputationError;
};

/// The integral's name in error messages, and the point at which it is evaluated.
struct IntegralName {
  std::string_view what;
  double at;
};

/// A Gauss–Kronrod rule by its number of points; few suffice for what is nearly a polynomial.
enum class GaussKronrod : int { points_15 = GSL_INTEG_GAUSS15, points_31 = GSL_INTEG_GAUSS31 };

/// QUADPACK's adaptive rules from GSL, with their workspace; a failure throws.
///
/// Each rule takes an integrand double(double), finite limits a < b and an absolute tolerance, and
/// returns the integral with QUADPACK's error estimate. The estimate excludes the rounding of the
/// sum; the caller, who knows the magnitudes, adds it. Throws QuadratureError for a result that is
/// not finite or whose estimate exceeds a thousand tolerances; exceptions from the integrand pass
/// through. GSL's own error handler, which aborts, is switched off. Not thread-safe: each thread
/// needs its own object.
class Quadrature {
 public:
  explicit Quadrature(std::size_t max_intervals = 1000);

  /// ∫ₐᵇ f(s) ds for f smooth inside: the nested 21/43/87-point Gauss–Kronrod–Patterson rules
  /// (QNG); if these fail, as for an f singular at an end, bisection with extrapolation (QAGS).
  template <class F>
  Estimate smooth(F&& f, double a, double b, double abs_tolerance, IntegralName name) {
    return integrate(Rule::smooth, f, {a, b, abs_tolerance, 0}, name);
  }

  /// ∫ₐᵇ f(s) ds by bisection with a Gauss–Kronrod rule (QAG).
  template <class F>
  Estimate adaptive(F&& f, double a, double b, double abs_tolerance, IntegralName name,
                    GaussKronrod rule = GaussKronrod::points_31) {
    return integrate(Rule::adaptive, f, {a, b, abs_tolerance, static_cast<double>(rule)}, name);
  }

  /// The Cauchy principal value PV∫ₐᵇ f(s)/(s − pole) ds (QAWC), pole ≠ a, b.
  template <class F>
  Estimate principal_value(F&& f, double a, double b, double pole, double abs_tolerance,
                           IntegralName name) {
    return integrate(Rule::principal_value, f, {a, b, abs_tolerance, pole}, name);
  }

 private:
  enum class Rule { smooth, adaptive, principal_value };

  struct Interval {
    double a, b, abs_tolerance;
    double parameter;  // the Gauss–Kronrod rule or the pole
  };

  // The integrand that GSL calls. An exception must not unwind through C: it is stored, the
  // integral becomes NaN, and the exception is rethrown after GSL has returned.
  template <class F>
  struct Integrand {
    explicit Integrand(F& f) : callable(f), gsl{&Integrand::call, this} {}
    static double call(double s, void* self) noexcept {
      auto& integrand = *static_cast<Integrand*>(self);
      try {
        return integrand.callable(s);
      } catch (...) {
        integrand.exception = std::current_exception();
        return std::numeric_limits<double>::quiet_NaN();
      }
    }
    F& callable;
    gsl_function gsl;
    std::exception_ptr exception;
  };

  template <class F>
  Estimate integrate(Rule rule, F& f, const Interval& interval, IntegralName name) {
    Integrand<F> integrand(f);
    try {
      return run(rule, &integrand.gsl, interval, name);
    } catch (const QuadratureError&) {
      if (integrand.exception) std::rethrow_exception(integrand.exception);
      throw;
    }
  }

  Estimate run(Rule rule, gsl_function* f, const Interval& interval, IntegralName name);

  struct FreeWorkspace {
    void operator()(gsl_integration_workspace* w) const { gsl_integration_workspace_free(w); }
  };
  std::size_t max_intervals_;
  std::unique_ptr<gsl_integration_workspace, FreeWorkspace> workspace_;
};

}  // namespace numerics
