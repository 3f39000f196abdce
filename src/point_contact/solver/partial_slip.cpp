// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/partial_slip.hpp"

#include <fmt/core.h>

#include <cmath>

#include "point_contact/solver/methods.hpp"
#include "system/require.hpp"

namespace point_contact {
namespace {

double require_coefficient(double friction_coefficient) {
  if (!(std::isfinite(friction_coefficient) && friction_coefficient >= 0)) {
    throw sys::InvalidQuantity("friction", friction_coefficient, "0 or greater");
  }
  return friction_coefficient;
}

// (2−ν)/G
double tangential_compliance_of(const elasticity::Material& material) {
  return (2 - material.poisson()) * 2 * (1 + material.poisson()) / material.young();
}

}  // namespace

Friction sliding(const Solution& solution, double friction_coefficient) {
  const double mu = require_coefficient(friction_coefficient);
  return {.shear = mu * solution.pressure,
          .tangential_load = mu * solution.load(),
          .stick_load = 0,
          .n_sticking = 0};
}

Friction partial_slip(const Problem& problem, const Solution& solution, double friction_coefficient,
                      double tangential_load, const Accuracy& accuracy) {
  const double limit = require_coefficient(friction_coefficient) * solution.load();
  if (!(std::abs(tangential_load) < limit)) {
    throw sys::InvalidQuantity(
        "tangential_load", tangential_load,
        fmt::format("less than friction holds, {}, or the bodies slide", limit));
  }
  const double stick_load = solution.load() - std::abs(tangential_load) / friction_coefficient;
  const Solution sticking = solve_for_load(problem, stick_load, accuracy);
  const double signed_coefficient = std::copysign(friction_coefficient, tangential_load);
  return {.shear = signed_coefficient * (solution.pressure - sticking.pressure),
          .tangential_load = tangential_load,
          .stick_load = stick_load,
          .n_sticking = sticking.n_in_contact(),
          .stick_approach = sticking.approach};
}

double tangential_compliance(const elasticity::Material& first,
                             const elasticity::Material& second) {
  return tangential_compliance_of(first) + tangential_compliance_of(second);
}

double tangential_displacement(const Problem& problem, const Solution& solution,
                               const Friction& friction, double friction_coefficient,
                               double compliance) {
  const double moved =
      problem.contact_modulus * compliance * (solution.approach - friction.stick_approach) / 4;
  return std::copysign(friction_coefficient, friction.tangential_load) * moved;
}

}  // namespace point_contact
