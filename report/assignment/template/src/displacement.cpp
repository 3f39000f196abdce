// SPDX-License-Identifier: GPL-3.0-or-later
// Exercise 3: the displacement under any load, from the datum.
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
struct Potential {
  const Load& load;
  double xi;
};

// p/p₀ times ln|ξ − σ|, with lengths in units of the half-width.
double weighted_logarithm(double sigma, void* parameters) {
  const auto& [load, xi] = *static_cast<const Potential*>(parameters);
  if (sigma == xi) return 0;
  return load.pressure(sigma * load.half_width) / load.unit_pressure *
         std::log(std::abs(xi - sigma));
}

// ∫ p/p₀ ln|ξ − σ| dσ over the load, split at the kink and at the singularity of the logarithm.
double logarithmic_potential(const Load& load, double xi) {
  gsl_set_error_handler_off();
  std::vector<double> points = {-1, 0, 1};
  if (std::abs(xi) < 1 && xi != 0) points.push_back(xi);
  std::sort(points.begin(), points.end());
  Potential potential{load, xi};
  gsl_function integrand{weighted_logarithm, &potential};
  gsl_integration_workspace* workspace = gsl_integration_workspace_alloc(1000);
  double value = 0;
  double abs_error = 0;
  gsl_integration_qagp(&integrand, points.data(), points.size(), 1e-11, 0, 1000, workspace, &value,
                       &abs_error);
  gsl_integration_workspace_free(workspace);
  return value;
}
// END SOLUTION

}  // namespace

double normal_displacement(const Material& material, const Load& load, double datum, double x) {
  // BEGIN SOLUTION
  // STUB: return std::numeric_limits<double>::quiet_NaN();
  const double a = load.half_width;
  const double rise = logarithmic_potential(load, x / a) - logarithmic_potential(load, datum / a);
  const double line_load = load.unit_pressure * a;
  const double nu = material.poisson;
  return -2 * (1 - nu * nu) * line_load / (std::numbers::pi * material.young) * rise;
  // END SOLUTION
}

}  // namespace exercise
