// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/methods.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>
#include <utility>

#include "contact/accuracy.hpp"
#include "contact/reference_methods.hpp"
#include "line_contact/nested_grids.hpp"
#include "system/require.hpp"

namespace line_contact {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// T(0), T(1), … T(n−1); the matrix of influence coefficients is T(|i−j|).
VectorXd influence_of(const Problem& problem) {
  require_valid(problem);
  const Index n = problem.grid.n_nodes;
  if (n > contact::max_dense_nodes) {
    throw sys::InvalidQuantity(
        "nodes", static_cast<double>(n),
        fmt::format("at most {} for a dense method (its matrix would take {:.3g} GB); fft takes "
                    "more",
                    contact::max_dense_nodes, 8e-9 * static_cast<double>(n * n)));
  }
  return VectorXd::NullaryExpr(
      n, [&](Index k) { return influence_coefficient(problem.element, static_cast<double>(k)); });
}

contact::Equations equations_of(const Problem& problem, double line_load,
                                const VectorXd& influence) {
  const Grid& grid = problem.grid;
  const double total = total_phi(problem, line_load);
  VectorXd gap = grid.nodes().unaryExpr([&](double x) { return problem.profile.gap(x); });
  gap.array() -= gap.minCoeff();
  // The terms of a gap in contact are of the order of Σφ times the greatest T. Gaps far outside may
  // be larger, but they exceed their own rounding.
  constexpr double roundings = 64;
  const double rounding =
      roundings * std::numeric_limits<double>::epsilon() * total * influence.cwiseAbs().maxCoeff();
  return {std::move(gap), total, rounding};
}

Solution solution_of(const Problem& problem, double line_load, contact::ContactLoads loads) {
  const double error = loads.misfit / loads.phi.maxCoeff();
  return to_solution(problem, line_load,
                     {std::move(loads.phi), std::move(loads.gap), error,
                      contact::Work{.revisions = loads.solves,
                                    .iterations = loads.products / 2,
                                    .products = loads.products}});
}

}  // namespace

Solution solve_by_matrix_inversion(const Problem& problem, double line_load) {
  const VectorXd influence = influence_of(problem);
  const contact::Equations equations = equations_of(problem, line_load, influence);
  return solution_of(problem, line_load, contact::invert(equations, [&](Index i, Index j) {
                       return influence[std::abs(i - j)];
                     }));
}

Solution solve_by_variational_method(const Problem& problem, double line_load) {
  const VectorXd influence = influence_of(problem);
  const contact::Equations equations = equations_of(problem, line_load, influence);
  const Index n = influence.size();
  const Eigen::MatrixXd compliance = Eigen::MatrixXd::NullaryExpr(
      n, n, [&](Index i, Index j) { return -influence[std::abs(i - j)]; });
  const auto displace = [&](const VectorXd& phi, VectorXd& u) { u = compliance * phi; };
  const int max_products = 1000 + static_cast<int>(400 * std::sqrt(n));
  return solution_of(problem, line_load, contact::minimise(equations, displace, 0, max_products));
}

Solution solve_by_fft(const Problem& problem, double line_load, double tolerance) {
  require_valid(problem);
  contact::require_tolerance(tolerance, min_tolerance);
  return to_solution(problem, line_load, solve_on_nested_grids(problem, line_load, tolerance));
}

}  // namespace line_contact
