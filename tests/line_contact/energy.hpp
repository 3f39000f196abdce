// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <numbers>

#include "line_contact/dense_methods.hpp"

namespace line_contact {

/// (½ pᵀCp + hᵀp)/E* of a solution, its least value, an area: E* times it is an energy per length.
inline double energy(const Problem& problem, const Solution& solution) {
  const DenseSystem system(problem, solution.line_load());
  const Eigen::VectorXd phi = solution.pressure / solution.pressure_per_phi;
  double sum = 0;
  for (Eigen::Index i = 0; i < system.size(); ++i) {
    double displacement = 0;
    for (Eigen::Index j = 0; j < system.size(); ++j) {
      displacement -= system.coefficient(i, j) * phi[j];
    }
    const double gap = system.equations.initial_gap[i] + system.least_gap;
    sum += system.equations.weights[i] * phi[i] * (displacement / 2 + gap);
  }
  return std::numbers::pi / 2 * sum;  // p = φ πE*/(2c), elements c wide
}

}  // namespace line_contact
