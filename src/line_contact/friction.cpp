// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/friction.hpp"

#include <fmt/core.h>

#include <cmath>

#include "line_contact/influence_operator.hpp"
#include "system/require.hpp"

namespace line_contact {
namespace {

double require_coefficient(double friction_coefficient) {
  if (!(std::isfinite(friction_coefficient) && friction_coefficient >= 0)) {
    throw sys::InvalidQuantity("friction", friction_coefficient, "0 or greater");
  }
  return friction_coefficient;
}

}  // namespace

Friction sliding(const Solution& solution, double friction_coefficient) {
  const double mu = require_coefficient(friction_coefficient);
  return {mu * solution.pressure, mu * solution.line_load(), 0};
}

Friction partial_slip(const Problem& problem, const Solution& solution, double friction_coefficient,
                      double tangential_load, const Method& method) {
  const double limit = require_coefficient(friction_coefficient) * solution.line_load();
  if (!(std::abs(tangential_load) < limit)) {
    throw sys::InvalidQuantity(
        "tangential_load", tangential_load,
        fmt::format("less than friction holds, {}, or the bodies slide", limit));
  }
  const double stick_load = solution.line_load() - std::abs(tangential_load) / friction_coefficient;
  const Solution sticking = method(problem, stick_load);
  const double signed_coefficient = std::copysign(friction_coefficient, tangential_load);
  return {signed_coefficient * (solution.pressure - sticking.pressure), tangential_load,
          stick_load};
}

Slopes surface_slopes(const Problem& problem, const Solution& solution,
                      const Eigen::VectorXd& shear, double beta) {
  if (solution.grid.is_one_sided) {
    throw sys::InvalidQuantity("one-sided grid's end", solution.grid.end(),
                               "only without friction, which is not symmetric");
  }
  // begin excerpt: slopes
  const Eigen::VectorXd phi = solution.pressure / solution.pressure_per_phi;
  return {-gradients_over_grid(solution.element, phi) / solution.grid.spacing,
          2 * beta / problem.contact_modulus * shear};
  // end excerpt: slopes
}

}  // namespace line_contact
