// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/methods.hpp"

#include <utility>

#include "contact/limits.hpp"
#include "contact/reference_methods.hpp"
#include "point_contact/solver/influence_operator.hpp"
#include "point_contact/solver/nested_grids.hpp"

namespace point_contact {

using Eigen::VectorXd;

Solution solve_for_load(const Problem& problem, double load, double tolerance) {
  contact::require_tolerance(tolerance, min_tolerance);
  return to_solution(problem, load, solve_on_nested_grids(problem, load, tolerance));
}

Solution solve_by_variational_method(const Problem& problem, double load, double tolerance) {
  constexpr int max_products = 20'000;
  contact::require_tolerance(tolerance, min_tolerance);
  const contact::Equations equations{initial_gaps(problem), total_phi(problem, load)};
  InfluenceOperator influence(problem.element, problem.grid.n1, problem.grid.n2);
  contact::ContactLoads loads = contact::minimise(
      equations, [&](const VectorXd& phi, VectorXd& u) { influence.displacements(phi, u); },
      tolerance, max_products);
  const double error = loads.misfit / loads.phi.maxCoeff();
  return to_solution(problem, load,
                     {std::move(loads.phi), std::move(loads.gap), loads.approach, error,
                      contact::Work{.iterations = loads.products / 2, .products = loads.products}});
}

}  // namespace point_contact
