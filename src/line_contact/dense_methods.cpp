// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/dense_methods.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>
#include <utility>

#include "line_contact/nested_grids.hpp"
#include "line_contact/solver.hpp"
#include "system/require.hpp"

namespace line_contact {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

Solution solution_of(const Problem& problem, double line_load, const DenseSystem& system,
                     contact::ContactLoads loads) {
  require_free_ends(problem, loads.phi, line_load);
  const double error = loads.misfit / loads.phi.maxCoeff();
  return to_solution(
      problem, line_load,
      {std::move(loads.phi), std::move(loads.gap), loads.approach + system.least_gap, error,
       contact::Work{.revisions = loads.solves,
                     .iterations = loads.products / 2,
                     .products = loads.products}});
}

}  // namespace

DenseSystem::DenseSystem(const Problem& problem, double line_load)
    : is_one_sided(problem.grid.is_one_sided) {
  require_valid(problem);
  sys::require_positive("load", line_load);
  const Grid& grid = problem.grid;
  if (grid.n_nodes > max_dense_nodes) {
    const auto n = static_cast<double>(grid.n_nodes);
    throw sys::InvalidQuantity(
        "nodes", n,
        fmt::format("from {} to {} for a dense method (its matrix would take {:.3g} GB); fft takes "
                    "more",
                    min_nodes, max_dense_nodes, 8e-9 * n * n));
  }
  influence = VectorXd::NullaryExpr(is_one_sided ? 2 * grid.n_nodes : grid.n_nodes, [&](Index k) {
    return influence_coefficient(problem.element, static_cast<double>(k));
  });
  VectorXd gap = grid.nodes().unaryExpr([&](double x) { return problem.profile.gap(x); });
  least_gap = gap.minCoeff();
  gap.array() -= least_gap;
  const double total = total_phi(problem, line_load);
  // The terms of a gap in contact are of the order of Σφ times the greatest T. The gaps far outside
  // may be of any size: they are greater than their rounding.
  constexpr double roundings = 64;
  const double rounding =
      roundings * std::numeric_limits<double>::epsilon() * total * influence.cwiseAbs().maxCoeff();
  equations = {std::move(gap),
               VectorXd::NullaryExpr(grid.n_nodes, [&](Index i) { return grid.weight(i); }), total,
               rounding};
}

Solution solve_by_matrix_inversion(const Problem& problem, double line_load) {
  const DenseSystem system(problem, line_load);
  return solution_of(problem, line_load, system,
                     contact::invert(system.equations,
                                     [&](Index i, Index j) { return system.coefficient(i, j); }));
}

Solution solve_by_variational_method(const Problem& problem, double line_load) {
  const DenseSystem system(problem, line_load);
  const Eigen::MatrixXd compliance = Eigen::MatrixXd::NullaryExpr(
      system.size(), system.size(), [&](Index i, Index j) { return -system.coefficient(i, j); });
  const auto displace = [&](const VectorXd& phi, VectorXd& u) { u = compliance * phi; };
  const int max_products = 1000 + static_cast<int>(400 * std::sqrt(system.size()));
  return solution_of(problem, line_load, system,
                     contact::minimise(system.equations, displace, 0, max_products));
}

}  // namespace line_contact
