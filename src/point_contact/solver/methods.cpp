// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/methods.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "contact/reference_methods.hpp"
#include "system/require.hpp"

namespace point_contact {
namespace {

using contact::ContactLoads;
using contact::Equations;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

bool reaches_an_end(const Grid& grid, const VectorXd& phi) {
  for (Index i = 0; i < grid.n1; ++i) {
    if (phi[grid.index(i, 0)] > 0 || phi[grid.index(i, grid.n2 - 1)] > 0) return true;
  }
  for (Index j = 0; j < grid.n2; ++j) {
    if (phi[grid.index(0, j)] > 0 || phi[grid.index(grid.n1 - 1, j)] > 0) return true;
  }
  return false;
}

// The greatest distance of a node in contact from the middle, in halves of the domain, along the
// lattice's two vectors.
double extent(const Grid& grid, const VectorXd& phi) {
  const double middle1 = static_cast<double>(grid.n1 - 1) / 2;
  const double middle2 = static_cast<double>(grid.n2 - 1) / 2;
  double greatest = 0;
  for (Index j = 0; j < grid.n2; ++j) {
    for (Index i = 0; i < grid.n1; ++i) {
      if (phi[grid.index(i, j)] == 0) continue;
      greatest = std::max({greatest, std::abs(static_cast<double>(i) - middle1) / middle1,
                           std::abs(static_cast<double>(j) - middle2) / middle2});
    }
  }
  return greatest;
}

// The side of a domain that holds the contact, by ever larger ones of a few nodes.
std::string domain_needed(Problem problem, Control control, double load_or_approach) {
  constexpr Index few = 64;
  constexpr int enough = 20;
  const Grid grid = problem.grid;
  double factor = 1;
  for (int i = 0; i < enough; ++i) {
    factor *= 2;
    problem.grid = grid.with_nodes(few, few);
    problem.grid.lattice.first *= factor;
    problem.grid.lattice.second *= factor;
    const VectorXd phi =
        solve_on_nested_grids(problem, control, load_or_approach, {.tolerance = 1e-3}).phi;
    if (reaches_an_end(problem.grid, phi)) continue;
    constexpr double two_coarse_nodes = 4.0 / few;
    const double side = static_cast<double>(grid.n1) * grid.lattice.first.norm();
    return fmt::format("a side of {:.3g} holds it",
                       side * factor * (extent(problem.grid, phi) + two_coarse_nodes));
  }
  return "it takes a much larger one";
}

Solution solve(const Problem& problem, Control control, double load_or_approach,
               const Accuracy& accuracy) {
  require_tolerance(accuracy.tolerance);
  ElementLoads loads = solve_on_nested_grids(problem, control, load_or_approach, accuracy);
  require_free_ends(problem, loads.phi, control, load_or_approach);
  if (control == Control::load) return to_solution(problem, load_or_approach, std::move(loads));
  const double found =
      std::numbers::pi * problem.contact_modulus * problem.grid.spacing() * loads.phi.sum();
  Solution solution = to_solution(problem, found, std::move(loads));
  solution.residuals.load = 0;
  return solution;
}

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

Equations equations_of(const VectorXd& gaps, double total) {
  return {gaps, total};
}

Solution solution_of(const Problem& problem, double load, const VectorXd& gaps,
                     ContactLoads loads) {
  require_free_ends(problem, loads.phi, Control::load, load);
  const double error = loads.misfit / loads.phi.maxCoeff();
  loads.gap = (gaps.array() < largest_length).select(loads.gap, gaps);
  return to_solution(problem, load,
                     {std::move(loads.phi), std::move(loads.gap), loads.approach, error,
                      contact::Work{.revisions = loads.solves,
                                    .iterations = loads.products / 2,
                                    .products = loads.products}});
}

}  // namespace

void require_tolerance(double tolerance) {
  constexpr double too_large = 0.01;
  if (!(tolerance >= min_tolerance && tolerance <= too_large)) {
    throw sys::InvalidQuantity(
        "tolerance", tolerance,
        fmt::format("from {}, which is rounding, to {}", min_tolerance, too_large));
  }
}

void require_free_ends(const Problem& problem, const VectorXd& phi, Control control,
                       double load_or_approach) {
  if (!reaches_an_end(problem.grid, phi)) return;
  const bool is_measured = std::isfinite(problem.profile.half_sides().maxCoeff());
  const Lattice& lattice = problem.grid.lattice;
  throw sys::InvalidQuantity(
      "domain side", static_cast<double>(problem.grid.n1) * lattice.first.norm(),
      is_measured ? "larger: the contact reaches the end of the measured surface's grid"
                  : fmt::format("larger, since the contact reaches the end of the grid; {}",
                                domain_needed(problem, control, load_or_approach)));
}

Solution solve_for_load(const Problem& problem, double load, const Accuracy& accuracy) {
  sys::require_positive("load", load);
  return solve(problem, Control::load, load, accuracy);
}

Solution solve_for_approach(const Problem& problem, double approach, const Accuracy& accuracy) {
  const double least_gap = initial_gaps(problem, RowTeam(accuracy.n_threads)).minCoeff();
  if (!(approach > least_gap && approach < largest_length)) {
    throw sys::InvalidQuantity(
        "approach", approach,
        fmt::format("greater than the least gap {}, or there is no contact, and less than {}",
                    least_gap, largest_length));
  }
  return solve(problem, Control::approach, approach, accuracy);
}

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
