// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/reference_methods.hpp"

#include <fmt/core.h>

#include <utility>

#include "contact/reference_methods.hpp"
#include "point_contact/solver/fft_solver.hpp"
#include "system/require.hpp"

namespace point_contact {
namespace {

using contact::ContactLoads;
using contact::Equations;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd influence_matrix(const Problem& problem) {
  const Grid& grid = problem.grid;
  const ElementPotential element(problem.element, grid.lattice);
  MatrixXd matrix(grid.size(), grid.size());
  for (Index column = 0; column < grid.size(); ++column) {
    const Index j = column / grid.n1;
    for (Index row = 0; row < grid.size(); ++row) {
      const Index rows = row / grid.n1 - j;
      const Index i = row % grid.n1 - grid.neighbour(column % grid.n1, j, 0, rows);
      matrix(row, column) =
          element(element.node(static_cast<double>(i), static_cast<double>(rows)));
    }
  }
  return matrix;
}

// Where there is no body the distance may be infinite, but the methods compute with it.
Equations equations_of(const VectorXd& gaps, double total) {
  return {gaps.cwiseMin(largest_length), (gaps.array() < largest_length).cast<double>(), total};
}

Solution solution_of(const Problem& problem, double load, const VectorXd& gaps,
                     ContactLoads loads) {
  require_free_ends(problem, loads.phi, Control::load, load);
  const double error = loads.misfit / loads.phi.maxCoeff();
  loads.gap = (gaps.array() < largest_length).select(loads.gap, gaps);
  return to_solution(problem, load,
                     {std::move(loads.phi), std::move(loads.gap), loads.approach, error,
                      Work{.revisions = loads.solves,
                           .iterations = loads.products / 2,
                           .products = loads.products}});
}

}  // namespace

Solution solve_by_matrix_inversion(const Problem& problem, double load) {
  const double total = total_phi(problem, load);
  if (problem.grid.size() > max_dense_nodes) {
    throw sys::InvalidQuantity("nodes", static_cast<double>(problem.grid.size()),
                               fmt::format("{} at most for matrix inversion", max_dense_nodes));
  }
  const VectorXd gaps = initial_gaps(problem, RowTeam(1));
  Equations equations = equations_of(gaps, total);
  const MatrixXd influence = influence_matrix(problem);
  equations.smallest_gap = 1e-15 * total * influence(0, 0);  // the rounding of a displacement
  return solution_of(problem, load, gaps, contact::invert(equations, [&](Index i, Index j) {
                       return -influence(i, j);
                     }));
}

Solution solve_by_variational_method(const Problem& problem, double load,
                                     const Accuracy& accuracy) {
  constexpr int max_products = 20'000;
  const double total = total_phi(problem, load);
  require_tolerance(accuracy.tolerance);
  const RowTeam team(accuracy.n_threads);
  const VectorXd gaps = initial_gaps(problem, team);
  const Equations equations = equations_of(gaps, total);
  InfluenceOperator influence(ElementPotential(problem.element, problem.grid.lattice), problem.grid,
                              team);
  const auto displace = [&](const VectorXd& phi, VectorXd& u) { influence.displacements(phi, u); };
  return solution_of(problem, load, gaps,
                     contact::minimise(equations, displace, accuracy.tolerance, max_products));
}

}  // namespace point_contact
