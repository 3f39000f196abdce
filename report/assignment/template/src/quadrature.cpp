// SPDX-License-Identifier: GPL-3.0-or-later
// Exercise 2: the slope under any load by numerical integration of eq. (2).
#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "assignment/given/student_functions.hpp"

namespace exercise {
namespace {

// BEGIN SOLUTION
struct Singular {
  const Load& load;
  double x;
  double pressure_at_x;
};

// [p(s) − p(x)]/(x − s), which remains finite at s = x.
double regular_part(double s, void* parameters) {
  const auto& [load, x, pressure_at_x] = *static_cast<const Singular*>(parameters);
  return s == x ? 0 : (load.pressure(s) - pressure_at_x) / (x - s);
}

// p(x) PV∫ ds/(x − s) over the load, which tends to 0 at the ends.
double singular_part(const Load& load, double x) {
  const double a = load.half_width;
  if (std::abs(x) >= a) return 0;
  return load.pressure(x) * std::log((a + x) / (a - x));
}

// The ends of the smooth pieces of the integrand, sorted, without duplicates.
std::vector<double> breakpoints(double a, double x) {
  std::vector<double> points = {-a, 0, a};
  if (std::abs(x) < a && x != 0) points.push_back(x);
  std::sort(points.begin(), points.end());
  return points;
}

Estimate integrate(Singular& singular, double abs_tolerance) {
  gsl_set_error_handler_off();
  std::vector<double> points = breakpoints(singular.load.half_width, singular.x);
  gsl_function integrand{regular_part, &singular};
  gsl_integration_workspace* workspace = gsl_integration_workspace_alloc(1000);
  Estimate integral{};
  gsl_integration_qagp(&integrand, points.data(), points.size(), abs_tolerance, 0, 1000, workspace,
                       &integral.value, &integral.abs_error);
  gsl_integration_workspace_free(workspace);
  return integral;
}
// END SOLUTION

}  // namespace

Estimate normal_gradient_by_quadrature(const Material& material, const Load& load, double x) {
  // BEGIN SOLUTION
  // STUB: const double unknown = std::numeric_limits<double>::quiet_NaN();
  // STUB: return {unknown, unknown};
  Singular singular{load, x, load.pressure(x)};
  Estimate integral = integrate(singular, 1e-10 * load.unit_pressure);
  integral.value += singular_part(load, x);
  integral.abs_error += 1e-13 * load.unit_pressure;  // rounding, which GSL's estimate ignores

  const double nu = material.poisson;
  const double compliance = 2 * (1 - nu * nu) / (std::numbers::pi * material.young);
  return {-compliance * integral.value, compliance * integral.abs_error};
  // END SOLUTION
}

}  // namespace exercise
